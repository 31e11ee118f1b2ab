// Independent reference for |∇C| = s: fast marching (Sethian 1996) with a heap, in double precision.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace mayfly::reference {

class FastMarching {
 public:
  FastMarching(std::array<int, 3> size, double cell, const std::vector<float>& slowness,
               const std::vector<float>& cost)
      : size_(size),
        stride_{1, static_cast<std::size_t>(size[0]),
                static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1])},
        cell_(cell),
        slowness_(slowness),
        value_(slowness.size(), kInfinity),
        final_(slowness.size(), false),
        source_(slowness.size(), false) {
    for (std::size_t c = 0; c < value_.size(); ++c) {
      if (!blocked(c) && !std::isinf(cost[c])) {
        source_[c] = true;
        value_[c] = static_cast<double>(cost[c]);
        heap_.emplace(value_[c], c);
      }
    }
  }

  std::vector<double> run() {
    while (!heap_.empty()) {
      const auto [cost_here, c] = heap_.top();
      heap_.pop();
      if (!final_[c] && cost_here <= value_[c]) {
        final_[c] = true;
        update_neighbours(c);
      }
    }
    return value_;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  using Entry = std::pair<double, std::size_t>;

  bool blocked(std::size_t c) const { return !(slowness_[c] > 0.0F) || std::isinf(slowness_[c]); }

  int coordinate(std::size_t c, std::size_t axis) const {
    return static_cast<int>(c / stride_[axis] % static_cast<std::size_t>(size_[axis]));
  }

  void update_neighbours(std::size_t c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (coordinate(c, axis) > 0) {
        update(c - stride_[axis]);
      }
      if (coordinate(c, axis) + 1 < size_[axis]) {
        update(c + stride_[axis]);
      }
    }
  }

  void update(std::size_t c) {
    if (final_[c] || source_[c] || blocked(c)) {
      return;
    }
    const double u = value_from_neighbours(c);
    if (u < value_[c]) {
      value_[c] = u;
      heap_.emplace(u, c);
    }
  }

  // Every neighbour counts with its present value: in a sweep order of any kind the fixed point is the same,
  // and here values that are not final are larger than the one being computed.
  double value_from_neighbours(std::size_t c) const {
    std::vector<double> a;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double before = coordinate(c, axis) > 0 ? value_[c - stride_[axis]] : kInfinity;
      const double after = coordinate(c, axis) + 1 < size_[axis] ? value_[c + stride_[axis]] : kInfinity;
      if (const double low = std::min(before, after); !std::isinf(low)) {
        a.push_back(low);
      }
    }
    std::sort(a.begin(), a.end());
    const double f = static_cast<double>(slowness_[c]) * cell_;
    double u = a[0] + f;
    for (std::size_t used = 2; used <= a.size() && u > a[used - 1]; ++used) {
      double sum = 0.0;
      double squares = 0.0;
      const auto n = static_cast<double>(used);
      for (std::size_t k = 0; k < used; ++k) {
        sum += a[k] - a[0];
        squares += (a[k] - a[0]) * (a[k] - a[0]);
      }
      u = a[0] + (sum + std::sqrt(std::max(sum * sum - n * (squares - f * f), 0.0))) / n;
    }
    return u;
  }

  std::array<int, 3> size_;
  std::array<std::size_t, 3> stride_;
  double cell_;
  const std::vector<float>& slowness_;
  std::vector<double> value_;
  std::vector<bool> final_;
  std::vector<bool> source_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap_;
};

// slowness: per cell, blocked where infinite or ≤ 0; cost: fixed values of source cells, +inf elsewhere. x
// fastest.
inline std::vector<double> fast_marching(int nx, int ny, int nz, double cell,
                                         const std::vector<float>& slowness, const std::vector<float>& cost) {
  return FastMarching({nx, ny, nz}, cell, slowness, cost).run();
}

}  // namespace mayfly::reference
