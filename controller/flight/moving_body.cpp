#include "controller/flight/moving_body.hpp"

#include <algorithm>
#include <utility>

#include "controller/flight/field_margin.hpp"
#include "fields/make_grid.hpp"

namespace mayfly {
namespace {

// Cells along the longest side of a mesh: as fine as that, a look at the samples decides nearly always.
constexpr float kCellsAcross = 48.0F;

// Half-spaces have none, but they have no path either.
Box bounds_of(const fields::Geometry& solid) {
  return solid.bounds().value_or(Box{});
}

Result<fields::DistanceField> sample_around(const fields::Geometry& solid, float world_cell, int threads) {
  Box box = bounds_of(solid);
  const glm::vec3 size = box.max - box.min;
  const float cell = std::max(std::max({size.x, size.y, size.z}) / kCellsAcross, 0.25F * world_cell);
  const float margin = 2.0F * world_cell;
  box = {box.min - margin, box.max + margin};
  return fields::make_grid(box, cell).and_then(
      [&](const Grid& grid) { return fields::build_distance_field(solid, grid, threads, {}); });
}

Result<MovingBody> make_body(const Scenario& scenario, std::size_t index, int threads) {
  const WorldSpec& world = scenario.world;
  const ObstacleSpec& spec = world.obstacles[index];
  const fields::PlacedShape shape{spec.shape, spec.place};
  auto solid = fields::Geometry::make({&shape, 1}, world.cell);
  if (!solid) {
    return fail(std::move(solid.error()));
  }
  MovingBody body{index, std::move(*solid), std::nullopt,
                  obstacle_margin(scenario, *spec.path, 0.0, set_duration(scenario))};
  if (std::holds_alternative<fields::MeshShape>(spec.shape)) {
    auto around = sample_around(body.solid, world.cell, threads);
    if (!around) {
      return fail(std::move(around.error()));
    }
    body.around = std::move(*around);
  }
  return body;
}

}  // namespace

tl::expected<std::vector<MovingBody>, std::vector<Error>> make_moving_bodies(const Scenario& scenario,
                                                                             int threads) {
  std::vector<MovingBody> bodies;
  std::vector<Error> errors;
  const auto& obstacles = scenario.world.obstacles;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (!obstacles[i].path) {
      continue;
    }
    auto body = make_body(scenario, i, threads);
    if (body) {
      bodies.push_back(std::move(*body));
    } else {
      errors.push_back(std::move(body.error()));
    }
  }
  if (!errors.empty()) {
    return tl::unexpected(std::move(errors));
  }
  return bodies;
}

std::vector<MovingObstacle> moving_obstacles(std::span<const MovingBody> bodies, const Motion& motion) {
  std::vector<MovingObstacle> obstacles;
  for (const MovingBody& body : bodies) {
    MovingObstacle obstacle;
    obstacle.bounds = bounds_of(body.solid);
    if (body.around) {
      obstacle.sampled = {body.around->distance.data(), body.around->grid};
    }
    obstacle.exact = [&solid = body.solid](glm::vec3 p) { return solid.signed_distance(p); };
    obstacle.displacement = &motion.obstacle(body.obstacle);
    obstacles.push_back(std::move(obstacle));
  }
  return obstacles;
}

}  // namespace mayfly
