#include "controller/flight/rest_places.hpp"

#include <algorithm>
#include <cstdint>

#include "controller/flight/scatter.hpp"

namespace mayfly {
namespace {

constexpr std::uint32_t kRestStream = 0x5E771E00U;
// After so many tries an agent takes a place that is too near another's: the minimum distance parts them in
// flight.
constexpr std::uint32_t kMostTries = 64;

// Centres of the cells that lie in the goal; if there is none, of the cell with the least cost.
std::vector<glm::vec3> goal_cells(const fields::CostField& cost) {
  std::vector<glm::vec3> inside;
  glm::vec3 cheapest{0.0F};
  float least = fields::kUnreachableGuide;
  for (int k = 0; k < cost.grid.cells.z; ++k) {
    for (int j = 0; j < cost.grid.cells.y; ++j) {
      for (int i = 0; i < cost.grid.cells.x; ++i) {
        const std::size_t cell = cost.grid.index(i, j, k);
        const float level = cost.guide[4 * cell + 3];
        if (cost.kind[cell] != fields::CellKind::kReached) {
          continue;
        }
        if (level < 0.0F) {
          inside.push_back(cost.grid.center(i, j, k));
        }
        if (level < least) {
          least = level;
          cheapest = cost.grid.center(i, j, k);
        }
      }
    }
  }
  if (inside.empty()) {
    inside.push_back(cheapest);
  }
  return inside;
}

}  // namespace

std::vector<glm::vec3> rest_places(const Scenario& scenario, const World& world, std::uint32_t index) {
  const SwarmSpec& swarm = scenario.swarms[index];
  const std::vector<glm::vec3> cells = goal_cells(*world.costs[index]);
  const float half_separation = 0.5F * swarm.limits.separation;
  Taken taken(swarm.limits.separation);
  std::vector<glm::vec3> places;
  for (std::uint32_t agent = 0; agent < static_cast<std::uint32_t>(swarm.count); ++agent) {
    glm::vec3 place = cells.front();
    for (std::uint32_t attempt = 0; attempt < kMostTries; ++attempt) {
      const DrawKey key{scenario.seed, kRestStream, index, agent, 2 * attempt};
      const glm::vec3 center = cells[draw_words(key)[0] % cells.size()];
      const glm::vec3 within =
          draw_unit_cube({scenario.seed, kRestStream, index, agent, 2 * attempt + 1}) - 0.5F;
      place = cells.size() > 1 ? center + within * world.grid.cell : center;
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
