// Collision avoidance in double precision, from van den Berg et al. 2011: the half-space of a pair as the
// nearest point of the velocity obstacle's outline, and the best velocity by trying every set of half-spaces
// that could hold it.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "tests/reference/noise_reference.hpp"

namespace mayfly::reference {

// n · v >= d.
struct HalfSpace {
  Vec n{};
  double d = 0;
};

struct Pair {
  Vec line;           // m, from the agent to the other
  Vec own, other;     // m/s
  double radius = 0;  // m, the sum of both
};

inline Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec unit(const Vec& v) {
  return v * (1.0 / norm(v));
}

// The nearest point of the outline in the plane of the line (first coordinate) and the relative velocity: the
// arc of the cut-off sphere between its points of contact with the cone, and the cone's side from there on.
struct Outline {
  double along, across;      // of the point, m/s
  double n_along, n_across;  // the normal there, outwards
};

inline Outline nearest_outline(double distance, double radius, double horizon, double along, double across) {
  const double centre = distance / horizon;
  const double r = radius / horizon;
  const double wx = along - centre;
  const double w = std::hypot(wx, across);
  Outline arc{centre + r * wx / w, r * across / w, wx / w, across / w};
  if (distance <= radius) {
    return arc;
  }
  const double sine = radius / distance;
  const double cosine = std::sqrt(1 - sine * sine);
  const double contact = cosine * centre;  // from the apex
  const double on_side = std::max(along * cosine + across * sine, contact);
  const Outline side{on_side * cosine, on_side * sine, -sine, cosine};
  const bool on_arc = arc.n_along <= -sine;
  const auto gap = [&](const Outline& o) { return std::hypot(along - o.along, across - o.across); };
  return on_arc && gap(arc) < gap(side) ? arc : side;
}

// `share` of the change is the agent's own.
inline HalfSpace orca_half_space(const Pair& pair, double share, double horizon, double period) {
  const double distance = norm(pair.line);
  const Vec axis = unit(pair.line);
  const Vec approach = pair.own - pair.other;
  const double along = dot(approach, axis);
  const Vec rest = approach - axis * along;
  const double across = norm(rest);
  const Vec sideways = rest * (1.0 / across);
  const Outline o =
      nearest_outline(distance, pair.radius, distance <= pair.radius ? period : horizon, along, across);
  const Vec n = axis * o.n_along + sideways * o.n_across;
  const Vec u = axis * (o.along - along) + sideways * (o.across - across);
  return {n, dot(n, pair.own + u * share)};
}

// The best velocity within `most`: every set of up to three half-spaces, with or without the speed limit, has
// one point that could be the best; the best of those that keep all is.
class BestVelocity {
 public:
  BestVelocity(std::vector<HalfSpace> planes, double most) : planes_(std::move(planes)), most_(most) {}

  // The velocity nearest to `wish` that breaks none by more than `slack`.
  std::optional<Vec> nearest(const Vec& wish, double slack) const {
    std::optional<Vec> best;
    const auto consider = [&](const Vec& v) {
      if (keeps(v, slack) && (!best || norm(v - wish) < norm(*best - wish))) {
        best = v;
      }
    };
    consider(wish);
    consider(unit(wish) * most_);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      on_plane(i, wish, consider);
      for (std::size_t j = 0; j < i; ++j) {
        on_line(i, j, wish, consider);
        for (std::size_t k = 0; k < j; ++k) {
          at_corner(i, j, k, consider);
        }
      }
    }
    return best;
  }

  // The least that the worst of the half-spaces from `hard` on has to be broken, m/s; those before are kept.
  double least_violation(std::size_t hard) const {
    double low = 0;
    double high = 4 * most_ + 10;
    for (const HalfSpace& p : planes_) {
      high = std::max(high, 2 * std::fabs(p.d) + 2 * most_);
    }
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      std::vector<HalfSpace> eased = planes_;
      for (std::size_t i = hard; i < eased.size(); ++i) {
        eased[i].d -= middle;
      }
      (BestVelocity(eased, most_).nearest({1e-3, 2e-3, -1e-3}, 1e-9) ? high : low) = middle;
    }
    return high;
  }

  double violation(const Vec& v, std::size_t from) const {
    double worst = 0;
    for (std::size_t i = from; i < planes_.size(); ++i) {
      worst = std::max(worst, planes_[i].d - dot(planes_[i].n, v));
    }
    return worst;
  }

 private:
  using Consider = std::function<void(const Vec&)>;

  bool keeps(const Vec& v, double slack) const {
    return norm(v) <= most_ + slack && violation(v, 0) <= slack;
  }

  void on_plane(std::size_t i, const Vec& wish, const Consider& consider) const {
    const HalfSpace& p = planes_[i];
    const Vec foot = wish + p.n * (p.d - dot(p.n, wish));
    consider(foot);
    const double room = most_ * most_ - p.d * p.d;
    const Vec across = foot - p.n * p.d;
    if (room >= 0 && norm(across) > 0) {
      consider(p.n * p.d + unit(across) * std::sqrt(room));
    }
  }

  void on_line(std::size_t i, std::size_t j, const Vec& wish, const Consider& consider) const {
    const HalfSpace &p = planes_[i], &q = planes_[j];
    const Vec direction = cross(p.n, q.n);
    const double sine2 = dot(direction, direction);
    if (sine2 < 1e-12) {
      return;
    }
    const double cosine = dot(p.n, q.n);
    const Vec point = p.n * ((p.d - q.d * cosine) / sine2) + q.n * ((q.d - p.d * cosine) / sine2);
    const Vec way = unit(direction);
    consider(point + way * dot(way, wish - point));
    const double room = most_ * most_ - dot(point, point);
    if (room >= 0) {
      consider(point + way * std::sqrt(room));
      consider(point - way * std::sqrt(room));
    }
  }

  void at_corner(std::size_t i, std::size_t j, std::size_t k, const Consider& consider) const {
    const HalfSpace &a = planes_[i], &b = planes_[j], &c = planes_[k];
    const double volume = dot(a.n, cross(b.n, c.n));
    if (std::fabs(volume) > 1e-12) {
      consider((cross(b.n, c.n) * a.d + cross(c.n, a.n) * b.d + cross(a.n, b.n) * c.d) * (1.0 / volume));
    }
  }

  std::vector<HalfSpace> planes_;
  double most_;
};

}  // namespace mayfly::reference
