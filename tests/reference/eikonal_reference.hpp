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

// slowness: per cell, blocked where infinite or ≤ 0; cost: fixed values of source cells, +inf elsewhere. x
// fastest.
inline std::vector<double> fast_marching(int nx, int ny, int nz, double cell,
                                         const std::vector<float>& slowness, const std::vector<float>& cost) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::size_t count = slowness.size();
  std::vector<double> value(count, infinity);
  std::vector<bool> final_value(count, false);
  std::vector<bool> source(count, false);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  const auto blocked = [&](std::size_t c) { return !(slowness[c] > 0.0F) || std::isinf(slowness[c]); };
  for (std::size_t c = 0; c < count; ++c) {
    if (!blocked(c) && !std::isinf(cost[c])) {
      value[c] = static_cast<double>(cost[c]);
      source[c] = true;
      heap.emplace(value[c], c);
    }
  }
  const std::array<int, 3> size{nx, ny, nz};
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(nx),
                                          static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny)};
  const auto coordinate = [&](std::size_t c, std::size_t axis) {
    return static_cast<int>(c / stride[axis] % static_cast<std::size_t>(size[axis]));
  };
  // Every neighbour counts with its present value: in a sweep order of any kind the fixed point is the same,
  // and here values that are not final are larger than the one being computed.
  const auto update = [&](std::size_t c) {
    std::vector<double> a;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double low = infinity;
      if (coordinate(c, axis) > 0) low = std::min(low, value[c - stride[axis]]);
      if (coordinate(c, axis) + 1 < size[axis]) low = std::min(low, value[c + stride[axis]]);
      if (!std::isinf(low)) a.push_back(low);
    }
    std::sort(a.begin(), a.end());
    const double f = static_cast<double>(slowness[c]) * cell;
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
  };
  while (!heap.empty()) {
    const auto [cost_here, c] = heap.top();
    heap.pop();
    if (final_value[c] || cost_here > value[c]) continue;
    final_value[c] = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        const int at = coordinate(c, axis) + side;
        if (at < 0 || at >= size[axis]) continue;
        const std::size_t neighbour = side < 0 ? c - stride[axis] : c + stride[axis];
        if (final_value[neighbour] || source[neighbour] || blocked(neighbour)) continue;
        const double u = update(neighbour);
        if (u < value[neighbour]) {
          value[neighbour] = u;
          heap.emplace(u, neighbour);
        }
      }
    }
  }
  return value;
}

}  // namespace mayfly::reference
