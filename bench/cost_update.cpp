// How long a cost field takes that is solved again in flight, 80 × 40 × 120 cells: for a goal that moved, an
// obstacle that moved, a crowd. Beside it the same from nothing, as before a flight. Prints ms, the least of
// twenty.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <vector>

#include "fields/cost_solver.hpp"
#include "fields/distance_field.hpp"
#include "fields/goal.hpp"
#include "fields/spline.hpp"

namespace mayfly::fields {
namespace {

double least_ms(int repeats, const auto& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work(i);
    best = std::min(
        best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

int run() {
  const Grid grid{glm::vec3(0.0F), 1.0F, {80, 120, 40}};
  const std::vector<PlacedShape> blocks{{BoxShape{{{10, 30, 0}, {35, 50, 30}}}, {}},
                                        {BoxShape{{{45, 30, 0}, {70, 50, 30}}}, {}},
                                        {SphereShape{{40, 80, 15}, 10.0F}, {}}};
  const PlacedShape goal{SphereShape{{40, 100, 20}, 3.0F}, {}};
  const auto geometry = Geometry::make(blocks, 1.0F);
  const auto distance = build_distance_field(*geometry, grid, 2, {});
  auto solver = CostSolver::make(grid, goal, {});
  CostField field = solver->make_field();
  for (const int threads : {1, 2}) {
    const double whole = least_ms(5, [&](int) {
      const auto region = build_goal_distance(goal, grid, threads, {});
      (void)build_cost_field(*distance, *region, {}, threads, {});
    });
    const double moved = least_ms(20, [&](int i) {
      (void)solver->solve({distance->distance, glm::vec3(0.5F * static_cast<float>(i), 0, 0), {}}, threads,
                          field);
    });
    const double spline = least_ms(5, [&](int) { (void)spline_coefficients(grid, distance->distance); });
    std::printf("%d threads: from nothing %.1f ms, goal moved %.1f ms, spline %.1f\n", threads, whole, moved,
                spline);
  }
  return 0;
}

}  // namespace
}  // namespace mayfly::fields

int main() {
  return mayfly::fields::run();
}
