// What is solved before a flight and in it: signed distance, a village's fields, a goal that moved.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include "bench/common/least_seconds.hpp"
#include "bench/fields/measure.hpp"
#include "bench/fields/village.hpp"
#include "fields/cost_solver.hpp"
#include "fields/distance_field.hpp"
#include "fields/make_grid.hpp"

namespace mayfly::bench {
namespace {

// A torus with waves on it, so that no two triangles are alike: 2·around·across triangles.
std::filesystem::path write_torus(int around, int across) {
  auto file =
      std::filesystem::temp_directory_path() / ("torus" + std::to_string(2 * around * across) + ".obj");
  std::ofstream out(file);
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * i / around;
      const double v = 2.0 * std::numbers::pi * j / across;
      const double r = 0.35 + 0.03 * std::sin(7.0 * u + 3.0 * v);
      out << "v " << (1.0 + r * std::cos(v)) * std::cos(u) << ' ' << (1.0 + r * std::cos(v)) * std::sin(u)
          << ' ' << r * std::sin(v) << '\n';
    }
  }
  const auto corner = [&](int i, int j) { return i % around * across + j % across + 1; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      out << "f " << corner(i, j) << ' ' << corner(i + 1, j) << ' ' << corner(i + 1, j + 1) << '\n';
      out << "f " << corner(i, j) << ' ' << corner(i + 1, j + 1) << ' ' << corner(i, j + 1) << '\n';
    }
  }
  return file;
}

Result<void> measure_distance(const FieldsPlan& plan, Report& report) {
  const int across = std::max(8, static_cast<int>(std::lround(std::sqrt(plan.torus_triangles / 4.48))));
  const auto file = write_torus(plan.torus_triangles / (2 * across), across);
  const fields::PlacedShape torus{fields::MeshShape{file, glm::vec3(50.0F), {}, 1.0F, 80.0F, false, {}}, {}};
  const auto geometry = fields::Geometry::make({&torus, 1}, 1.0F);
  if (!geometry) {
    return fail(geometry.error());
  }
  const auto grid = fields::make_grid({glm::vec3(0.0F), glm::vec3(100.0F)}, 1.0F);
  const double seconds = least_seconds(
      3, [&](int) { static_cast<void>(fields::build_distance_field(*geometry, *grid, plan.threads, {})); });
  report.rows.push_back(
      {.key = "distance",
       .what = "signed distance, " + std::to_string(geometry->triangle_count()) + " triangles, 100^3 cells",
       .value = seconds,
       .unit = "s",
       .wanted = 0.5});
  return {};
}

// A ball that moves between three obstacles, on the grid of the paper's chase.
Result<void> measure_moved_goal(const FieldsPlan& plan, Report& report) {
  const Grid grid{glm::vec3(0.0F), 1.0F, {80, 120, 40}};
  const std::vector<fields::PlacedShape> solids{{fields::BoxShape{{{10, 30, 0}, {35, 50, 30}}}, {}},
                                                {fields::BoxShape{{{45, 30, 0}, {70, 50, 30}}}, {}},
                                                {fields::SphereShape{{40, 80, 15}, 10.0F}, {}}};
  const auto geometry = fields::Geometry::make(solids, 1.0F);
  const auto distance = fields::build_distance_field(*geometry, grid, plan.threads, {});
  auto solver = fields::CostSolver::make(grid, {fields::SphereShape{{40, 100, 20}, 3.0F}, {}}, {});
  if (!distance || !solver) {
    return fail(distance ? solver.error() : distance.error());
  }
  fields::CostField field = solver->make_field();
  const double seconds = least_seconds(20, [&](int n) {
    static_cast<void>(solver->solve(
        {distance->distance, glm::vec3(0.5F * static_cast<float>(n), 0.0F, 0.0F), {}}, plan.threads, field));
  });
  report.rows.push_back({.key = "moved_goal",
                         .what = "goal moved, 80 x 40 x 120 cells, solved again",
                         .value = 1e3 * seconds,
                         .unit = "ms",
                         .wanted = 45.0,
                         .baseline = "Wang14's own",
                         .baseline_value = 729.0});
  return {};
}

Result<void> measure_preprocessing(const FieldsPlan& plan, Report& report) {
  const auto village = make_village({.agents = 1, .threads = plan.threads});
  if (!village) {
    return fail(village.error().front());
  }
  const PreprocessingSummary& took = village->ready->world.preprocessing;
  report.rows.push_back({.key = "preprocessing",
                         .what = "locusts' village, 120 x 50 x 55 cells, all fields",
                         .value = took.distance + took.noise + took.cost,
                         .unit = "s",
                         .wanted = 0.5,
                         .baseline = "Wang14's own",
                         .baseline_value = 19.405});
  return {};
}

}  // namespace

Result<void> measure_solvers(const FieldsPlan& plan, Report& report) {
  measure_eikonal(plan, report);
  return measure_distance(plan, report)
      .and_then([&] { return measure_preprocessing(plan, report); })
      .and_then([&] { return measure_moved_goal(plan, report); });
}

}  // namespace mayfly::bench
