// The eikonal solver in empty worlds and in such with three walls that have gaps, beside plain scalar fast
// sweeping (Zhao 2005) on one thread.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "bench/fields/measure.hpp"
#include "fields/eikonal.hpp"

namespace mayfly::bench {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Problem {
  Grid grid;
  std::vector<float> slowness;
  std::vector<float> cost;
};

// Walls across x at a quarter, a half and three quarters, with a gap a tenth wide at alternating ends in y.
Problem make(int n, bool walls) {
  Problem p{{glm::vec3(0.0F), 1.0F, glm::ivec3(n)}, {}, {}};
  p.slowness.assign(p.grid.size(), 1.0F);
  p.cost.assign(p.grid.size(), kInfinity);
  for (int wall = 1; walls && wall <= 3; ++wall) {
    const int first = wall % 2 == 1 ? n / 10 : 0;
    for (int z = 0; z < n; ++z) {
      for (int y = first; y < first + n - n / 10; ++y) {
        p.slowness[p.grid.index(wall * n / 4, y, z)] = kInfinity;
      }
    }
  }
  p.cost[p.grid.index(walls ? n / 20 : n / 2, n / 2, n / 2)] = 0.0F;
  return p;
}

// The baseline, as one would write it: eight orders, one cell after the other, until nothing changes.
class ScalarSweeping {
 public:
  explicit ScalarSweeping(Problem& problem) : p_(problem), fixed_(problem.cost.size()) {
    for (std::size_t c = 0; c < fixed_.size(); ++c) {
      fixed_[c] = p_.cost[c] != kInfinity || p_.slowness[c] == kInfinity;
    }
  }

  void run() {
    for (bool changed = true; changed;) {
      changed = false;
      for (int order = 0; order < 8; ++order) {
        changed |= sweep((order & 1) != 0, (order & 2) != 0, (order & 4) != 0);
      }
    }
  }

 private:
  bool sweep(bool back_x, bool back_y, bool back_z) {
    const int n = p_.grid.cells.x;
    bool changed = false;
    for (int c = 0; c < n; ++c) {
      for (int b = 0; b < n; ++b) {
        for (int a = 0; a < n; ++a) {
          changed |= update(back_x ? n - 1 - a : a, back_y ? n - 1 - b : b, back_z ? n - 1 - c : c);
        }
      }
    }
    return changed;
  }

  float at(int x, int y, int z) const {
    const int n = p_.grid.cells.x;
    const bool inside = x >= 0 && y >= 0 && z >= 0 && x < n && y < n && z < n;
    return inside ? p_.cost[p_.grid.index(x, y, z)] : kInfinity;
  }

  bool update(int x, int y, int z) {
    const std::size_t cell = p_.grid.index(x, y, z);
    if (fixed_[cell]) {
      return false;
    }
    float a[3] = {std::min(at(x - 1, y, z), at(x + 1, y, z)), std::min(at(x, y - 1, z), at(x, y + 1, z)),
                  std::min(at(x, y, z - 1), at(x, y, z + 1))};
    std::sort(a, a + 3);
    const float f = p_.slowness[cell];
    // On differences: sums of squares of the costs themselves would lose the digits that tell when it is
    // done.
    const float p = a[1] - a[0];
    const float q = a[2] - a[0];
    float u = a[0] + f;
    if (u > a[1]) {
      u = a[0] + 0.5F * (p + std::sqrt(2.0F * f * f - p * p));
      if (u > a[2]) {
        u = a[0] +
            (p + q + std::sqrt(std::max((p + q) * (p + q) - 3.0F * (p * p + q * q - f * f), 0.0F))) / 3.0F;
      }
    }
    if (!(u < p_.cost[cell])) {
      return false;
    }
    p_.cost[cell] = u;
    return true;
  }

  Problem& p_;
  std::vector<bool> fixed_;
};

// ns a cell, the least of `repeats`.
template <class Function>
double measure(const Problem& problem, int repeats, Function solve) {
  double best = 1e30;
  for (int n = 0; n < repeats; ++n) {
    Problem p = problem;
    const auto begin = std::chrono::steady_clock::now();
    solve(p);
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
    best = std::min(best, time.count() / static_cast<double>(p.grid.size()));
  }
  return best;
}

Row compare(int n, bool walls, int threads) {
  const Problem problem = make(n, walls);
  const double scalar = measure(problem, 1, [](Problem& p) { ScalarSweeping(p).run(); });
  const double ours = measure(problem, 5, [&](Problem& p) {
    static_cast<void>(fields::solve_eikonal(p.grid, p.slowness, p.cost, static_cast<unsigned>(threads)));
  });
  const std::string world = walls ? "three walls" : "empty";
  return {.key = "eikonal_" + std::to_string(n) + (walls ? "_walls" : "_empty"),
          .what = "eikonal, " + std::to_string(n) + "^3 cells, " + world + ", a cell",
          .value = ours,
          .unit = "ns",
          .wanted = 110.0,
          .baseline = "scalar fast sweeping",
          .baseline_value = scalar};
}

}  // namespace

void measure_eikonal(const FieldsPlan& plan, Report& report) {
  for (int n = 100; n <= plan.largest_grid; n += 100) {
    report.rows.push_back(compare(n, false, plan.threads));
    report.rows.push_back(compare(n, true, plan.threads));
  }
}

}  // namespace mayfly::bench
