// The force model in double precision, pair by pair, as model.md §5 has it (BSwarm15 Eqs. 2 to 5). Calls
// nothing of the code under test.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace mayfly::reference {

struct Vec3 {
  double x = 0, y = 0, z = 0;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double s, Vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double length(Vec3 a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}
inline Vec3 unit(Vec3 a) {
  const double l = length(a);
  return l < 1e-9 ? Vec3{} : (1 / l) * a;
}

struct Zones {
  double rep_weight = 0, ali_weight = 0, att_weight = 0;
  double rep = 0, ali = 0, att = 0;  // m, radii
};

struct Agents {
  std::vector<Vec3> r, v;
};

// One agent's interaction.
struct Interaction {
  Vec3 force{};          // m/s²
  double uncertain = 0;  // m/s²: what pairs may change that are on a zone's edge but for float's rounding
  std::size_t in_rep = 0, in_ali = 0, in_att = 0;
};

inline Interaction interaction(const Agents& all, std::size_t i, const Zones& z) {
  constexpr double kRounding = 1e-6;
  Interaction sum;
  Vec3 rep{}, ali{}, att{};
  std::size_t on_edge = 0;
  for (std::size_t j = 0; j < all.r.size(); ++j) {
    if (j == i || std::isnan(all.r[j].x + all.r[j].y + all.r[j].z)) {
      continue;
    }
    const Vec3 line = all.r[j] - all.r[i];
    const double distance = length(line);
    for (const double edge : {z.rep, z.ali, z.att}) {
      on_edge += distance != edge && std::fabs(distance - edge) < kRounding * edge ? 1U : 0U;
    }
    if (distance < z.rep) {  // g = −1
      rep = rep - unit(line);
      ++sum.in_rep;
    } else if (distance < z.ali) {  // g = 0
      ali = ali + unit(all.v[j] - all.v[i]);
      ++sum.in_ali;
    } else if (distance <= z.att) {  // g = +1
      att = att + unit(line);
      ++sum.in_att;
    }
  }
  const auto mean = [&](double weight, Vec3 total, std::size_t count) {
    sum.uncertain += 2 * weight * static_cast<double>(on_edge) / static_cast<double>(count + 1);
    return count == 0 ? Vec3{} : (weight / static_cast<double>(count)) * total;
  };
  sum.force = mean(z.rep_weight, rep, sum.in_rep) + mean(z.ali_weight, ali, sum.in_ali) +
              mean(z.att_weight, att, sum.in_att);
  return sum;
}

inline Vec3 friction(Vec3 v, double gamma) {
  return (-gamma * length(v)) * v;
}

// u turned about +z.
inline Vec3 turned(Vec3 u, double angle) {
  return {std::cos(angle) * u.x - std::sin(angle) * u.y, std::sin(angle) * u.x + std::cos(angle) * u.y, u.z};
}

}  // namespace mayfly::reference
