// Eikonal solver: ns a cell on 100³ and 200³ cells, empty and with three walls that have gaps, beside plain
// scalar fast sweeping (Zhao 2005) on one thread in the same run. Prints the ratio; a number as argument
// limits the size.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "fields/eikonal.hpp"

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Problem {
  mayfly::Grid grid;
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

void compare(int n, bool walls) {
  const Problem problem = make(n, walls);
  const double scalar = measure(problem, n > 100 ? 1 : 2, [](Problem& p) { ScalarSweeping(p).run(); });
  int sweeps = 0;
  double ours[2];
  for (const unsigned threads : {1U, 2U}) {
    ours[threads - 1] = measure(problem, 5, [&](Problem& p) {
      const auto stats = mayfly::fields::solve_eikonal(p.grid, p.slowness, p.cost, threads);
      sweeps = stats ? stats->sweeps : -1;
    });
  }
  std::printf("%3d^3 %-16s %12.1f %12.1f %12.1f %4.0f /%4.0f %8d\n", n, walls ? "three walls" : "empty",
              scalar, ours[0], ours[1], scalar / ours[0], scalar / ours[1], sweeps);
}

}  // namespace

int main(int argc, char** argv) {
  const double largest = argc > 1 ? std::strtod(argv[1], nullptr) : 200.0;
  std::printf("%-22s %12s %12s %12s %10s %8s\n", "world", "scalar ns", "1 thread ns", "2 threads ns",
              "ratio 1/2", "sweeps");
  for (const int n : {100, 200}) {
    if (n <= largest) {
      compare(n, false);
      compare(n, true);
    }
  }
  return 0;
}
