#include "controller/flight/rest_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "controller/flight/scatter.hpp"

namespace mayfly {
namespace {

constexpr std::uint32_t kRestStream = 0x5E771E00U;
// After so many tries an agent takes a place that is too near another's: the minimum distance parts them in
// flight.
constexpr std::uint32_t kMostTries = 64;

struct GoalCell {
  glm::vec3 center;
  float side;            // m
  std::uint64_t so_far;  // how many of the smallest cells this one and those before it hold
};

// The cells that lie in the goal; if there is none, the one with the least cost.
std::vector<GoalCell> goal_cells(const fields::CostField& cost) {
  std::vector<GoalCell> inside;
  GoalCell cheapest{glm::vec3(0.0F), cost.grid.cell, 1};
  float least = fields::kUnreachableGuide;
  std::uint64_t so_far = 0;
  cost.for_each_cell([&](std::size_t cell, glm::vec3 center, float side) {
    const float level = cost.guide[4 * cell + 3];
    if (cost.kind[cell] != fields::CellKind::kReached) {
      return;
    }
    if (level < 0.0F) {
      const auto ratio = static_cast<std::uint64_t>(std::lround(side / cost.grid.cell));
      so_far += ratio * ratio * ratio;
      inside.push_back({center, side, so_far});
    }
    if (level < least) {
      least = level;
      cheapest.center = center;
    }
  });
  if (inside.empty()) {
    inside.push_back(cheapest);
  }
  return inside;
}

// Uniform by volume.
const GoalCell& pick(const std::vector<GoalCell>& cells, std::uint32_t word) {
  const std::uint64_t wanted = word % cells.back().so_far;
  return *std::upper_bound(cells.begin(), cells.end(), wanted,
                           [](std::uint64_t value, const GoalCell& cell) { return value < cell.so_far; });
}

}  // namespace

std::vector<glm::vec3> rest_places(const Scenario& scenario, const World& world, std::uint32_t index) {
  const SwarmSpec& swarm = scenario.swarms[index];
  const std::vector<GoalCell> cells = goal_cells(*world.costs[index]);
  const float half_separation = 0.5F * swarm.limits.separation;
  Taken taken(swarm.limits.separation);
  std::vector<glm::vec3> places;
  for (std::uint32_t agent = 0; agent < static_cast<std::uint32_t>(swarm.count); ++agent) {
    glm::vec3 place = cells.front().center;
    for (std::uint32_t attempt = 0; attempt < kMostTries; ++attempt) {
      const DrawKey key{scenario.seed, kRestStream, index, agent, 2 * attempt};
      const GoalCell& cell = pick(cells, draw_words(key)[0]);
      const glm::vec3 within =
          draw_unit_cube({scenario.seed, kRestStream, index, agent, 2 * attempt + 1}) - 0.5F;
      place = cells.size() > 1 ? cell.center + within * cell.side : cell.center;
      if (distance_at_start(world, place) >= swarm.radius && taken.is_free(place, half_separation)) {
        break;
      }
    }
    taken.take(place, half_separation);
    places.push_back(place);
  }
  return places;
}

}  // namespace mayfly
