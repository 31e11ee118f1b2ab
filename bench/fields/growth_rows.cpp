// How time grows: with agents it should be linear, and with the grid and the meshes not at all (Wang14 Fig.
// 14).
#include <algorithm>
#include <cmath>

#include "bench/common/ticks.hpp"
#include "bench/fields/measure.hpp"
#include "bench/fields/village.hpp"

namespace mayfly::bench {
namespace {

using Outcome = tl::expected<void, std::vector<Error>>;

// Other programs on the machine come and go: of several rounds over all worlds, each world's fastest counts.
constexpr int kRounds = 5;
// Wang14's own number, and a crowd whose agents touch most of the tables at every tick.
constexpr std::size_t kCrowds[] = {5'000, 65'536};

using Villages = std::vector<Village>;

tl::expected<Villages, std::vector<Error>> build(const FieldsPlan& plan, std::vector<VillagePlan> worlds) {
  Villages villages;
  for (VillagePlan& world : worlds) {
    world.everywhere = true;
    world.threads = plan.threads;
    auto village = make_village(world);
    if (!village) {
      return tl::unexpected(std::move(village.error()));
    }
    villages.push_back(std::move(*village));
  }
  return villages;
}

// ns an agent and tick in each village.
Result<std::vector<double>> time_villages(const FieldsPlan& plan, const Villages& villages) {
  std::vector<double> least(villages.size(), INFINITY);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t v = 0; v < villages.size(); ++v) {
      const auto engine = make_native_engine(plan.threads);
      const auto ticks = time_ticks(*engine, flock_of(villages[v]), plan.ticks);
      if (!ticks) {
        return fail(ticks.error());
      }
      const auto agents = static_cast<double>(villages[v].ready->models.agents());
      least[v] = std::min(least[v], 1e9 * ticks->seconds / agents);
    }
  }
  return least;
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

Outcome with_agents(const FieldsPlan& plan, Report& report) {
  Curve curve{"agents", "Time against agents", "agents", "ns an agent and tick", {}};
  auto& line = curve.lines.emplace_back("native", std::vector<glm::dvec2>{}).second;
  for (std::size_t agents = 1024; agents <= plan.most_agents; agents *= 4) {
    const auto village = build(plan, {{.agents = agents}});
    if (!village) {
      return tl::unexpected(village.error());
    }
    const auto ns = time_villages(plan, *village);
    if (!ns) {
      return tl::unexpected(std::vector{ns.error()});
    }
    line.emplace_back(static_cast<double>(agents), ns->front());
  }
  report.curves.push_back(std::move(curve));
  return {};
}

// A family of worlds that differ in one size.
struct Growth {
  std::string key, title;  // of what grows
  std::string unit;
  std::vector<VillagePlan> worlds;
  double (*size)(const World& world);
};

Curve preprocessing(const Growth& growth, const Villages& villages) {
  std::vector<glm::dvec2> distance;
  std::vector<glm::dvec2> cost;
  for (const Village& village : villages) {
    const World& world = village.ready->world;
    distance.emplace_back(growth.size(world), world.preprocessing.distance);
    cost.emplace_back(growth.size(world), world.preprocessing.cost);
  }
  return {growth.key + "_built",
          "Preprocessing against " + growth.title,
          growth.unit,
          "s",
          {{"distance", std::move(distance)}, {"cost", std::move(cost)}}};
}

Outcome with_worlds(const FieldsPlan& plan, Growth growth, Report& report) {
  Curve ticks{growth.key, "Time against " + growth.title, growth.unit, "ns an agent and tick", {}};
  for (const std::size_t crowd : kCrowds) {
    const std::size_t agents = std::min(crowd, plan.most_agents);
    for (VillagePlan& world : growth.worlds) {
      world.agents = agents;
    }
    const auto villages = build(plan, growth.worlds);
    if (!villages) {
      return tl::unexpected(villages.error());
    }
    const auto ns = time_villages(plan, *villages);
    if (!ns) {
      return tl::unexpected(std::vector{ns.error()});
    }
    auto& line =
        ticks.lines.emplace_back(std::to_string(agents) + " agents", std::vector<glm::dvec2>{}).second;
    for (std::size_t v = 0; v < villages->size(); ++v) {
      line.emplace_back(growth.size((*villages)[v].ready->world), (*ns)[v]);
    }
    report.rows.push_back({.key = growth.key + "_spread_" + std::to_string(crowd),
                           .what = ticks.title + ", " + std::to_string(agents) + " agents: most / least",
                           .value = spread(line),
                           .unit = "",
                           .wanted = 1.1});
    if (crowd == kCrowds[0]) {
      report.curves.push_back(preprocessing(growth, *villages));
    }
  }
  report.curves.push_back(std::move(ticks));
  return {};
}

}  // namespace

Outcome measure_growth(const FieldsPlan& plan, Report& report) {
  std::vector<VillagePlan> grids;
  for (const float cell : {2.0F, 1.4F, 1.0F, 0.7F}) {
    grids.push_back({.cell = cell});
  }
  std::vector<VillagePlan> meshes;
  for (int subdivisions = 0; subdivisions <= (plan.largest_grid > 100 ? 3 : 1); ++subdivisions) {
    meshes.push_back({.subdivisions = subdivisions});
  }
  const auto cells = [](const World& world) { return static_cast<double>(world.grid.size()); };
  const auto triangles = [](const World& world) { return static_cast<double>(world.solid.triangle_count()); };
  return with_agents(plan, report)
      .and_then([&] {
        return with_worlds(plan, {"grid", "grid size", "cells", grids, cells}, report);
      })
      .and_then([&] {
        return with_worlds(plan, {"mesh", "mesh size", "triangles", meshes, triangles}, report);
      });
}

}  // namespace mayfly::bench
