// How time grows: with agents it should be linear, and with the grid and the meshes not at all (Wang14 Fig.
// 14).
#include <algorithm>
#include <cmath>

#include "bench/fields/measure.hpp"
#include "bench/fields/ticks.hpp"

namespace mayfly::bench {
namespace {

using Outcome = tl::expected<void, std::vector<Error>>;

struct Sample {
  double ns_per_agent = 0.0;
  double distance_s = 0.0, cost_s = 0.0;  // of preparing
  double triangles = 0.0, cells = 0.0;
};

tl::expected<Sample, std::vector<Error>> sample(const FieldsPlan& plan, VillagePlan of) {
  of.everywhere = true;
  of.threads = plan.threads;
  const auto village = make_village(of);
  if (!village) {
    return tl::unexpected(village.error());
  }
  const auto engine = make_native_engine(plan.threads);
  const auto ticks = time_ticks(*engine, *village, plan.ticks);
  if (!ticks) {
    return tl::unexpected(std::vector{ticks.error()});
  }
  const World& world = village->ready->world;
  return Sample{1e9 * ticks->seconds / static_cast<double>(of.agents), world.preprocessing.distance,
                world.preprocessing.cost, static_cast<double>(world.solid.triangle_count()),
                static_cast<double>(world.grid.size())};
}

// Largest over least of a line's values.
double spread(const std::vector<glm::dvec2>& line) {
  double least = INFINITY;
  double most = 0.0;
  for (const glm::dvec2 point : line) {
    least = std::min(least, point.y);
    most = std::max(most, point.y);
  }
  return most / least;
}

Outcome with_agents(const FieldsPlan& plan, FieldsReport& report) {
  Curve curve{"agents", "Time against agents", "agents", "ns an agent and tick", {}};
  auto& line = curve.lines.emplace_back("native", std::vector<glm::dvec2>{}).second;
  for (std::size_t agents = 1024; agents <= plan.most_agents; agents *= 4) {
    const auto point = sample(plan, {.agents = agents});
    if (!point) {
      return tl::unexpected(point.error());
    }
    line.emplace_back(static_cast<double>(agents), point->ns_per_agent);
  }
  report.curves.push_back(std::move(curve));
  return {};
}

// Time and preprocessing over a changing world; the last of `worlds` is the finest.
Outcome with_worlds(const FieldsPlan& plan, const std::vector<VillagePlan>& worlds, Curve ticks, Curve built,
                    double Sample::*size, FieldsReport& report) {
  auto& time = ticks.lines.emplace_back("native", std::vector<glm::dvec2>{}).second;
  std::vector<glm::dvec2> distance;
  std::vector<glm::dvec2> cost;
  for (const VillagePlan& world : worlds) {
    const auto point = sample(plan, world);
    if (!point) {
      return tl::unexpected(point.error());
    }
    time.emplace_back((*point).*size, point->ns_per_agent);
    distance.emplace_back((*point).*size, point->distance_s);
    cost.emplace_back((*point).*size, point->cost_s);
  }
  report.rows.push_back({.key = ticks.key + "_spread",
                         .what = ticks.title + ": slowest over fastest",
                         .value = spread(time),
                         .unit = "",
                         .wanted = 1.1});
  built.lines = {{"distance", std::move(distance)}, {"cost", std::move(cost)}};
  report.curves.push_back(std::move(ticks));
  report.curves.push_back(std::move(built));
  return {};
}

}  // namespace

Outcome measure_growth(const FieldsPlan& plan, FieldsReport& report) {
  const std::size_t agents = std::min<std::size_t>(65'536, plan.most_agents);
  std::vector<VillagePlan> grids;
  for (const float cell : {2.0F, 1.4F, 1.0F, 0.7F}) {
    grids.push_back({.agents = agents, .cell = cell});
  }
  std::vector<VillagePlan> meshes;
  for (int subdivisions = 0; subdivisions <= (plan.largest_grid > 100 ? 3 : 1); ++subdivisions) {
    meshes.push_back({.agents = agents, .subdivisions = subdivisions});
  }
  return with_agents(plan, report)
      .and_then([&] {
        return with_worlds(
            plan, grids, {"grid", "Time against grid size", "cells", "ns an agent and tick", {}},
            {"grid_built", "Preprocessing against grid size", "cells", "s", {}}, &Sample::cells, report);
      })
      .and_then([&] {
        return with_worlds(plan, meshes,
                           {"mesh", "Time against mesh size", "triangles", "ns an agent and tick", {}},
                           {"mesh_built", "Preprocessing against mesh size", "triangles", "s", {}},
                           &Sample::triangles, report);
      });
}

}  // namespace mayfly::bench
