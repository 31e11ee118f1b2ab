#include "controller/flight/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <span>
#include <string>
#include <tuple>

#include "controller/flight/flight_config.hpp"
#include "controller/flight/motion.hpp"
#include "controller/flight/scatter.hpp"
#include "controller/governor/group_model.hpp"

namespace mayfly {
namespace {

// Tries for one agent before the region counts as full.
constexpr std::uint32_t kMostTries = 20'000;
// Keeps these draws apart from every other use of the seed.
constexpr std::uint32_t kPlacementStream = 0x91ACE000U;

// What one agent keeps from others, m.
struct Room {
  float to_obstacles = 0.0F;
  float half_separation = 0.0F;  // both halves add up
  bool governed = false;
};

// As its planner wants it, and at least as the governor does: chance must not decide whether a start is safe.
std::vector<Room> rooms_of(const Scenario& scenario, const World& world) {
  const Motion motion(scenario);
  const GovernorConfig config = governor_config(scenario, world, motion);
  std::vector<Room> rooms;
  for (std::size_t s = 0; s < scenario.swarms.size(); ++s) {
    const SwarmSpec& swarm = scenario.swarms[s];
    Room room{swarm.radius, 0.5F * swarm.limits.separation, swarm.governor};
    if (swarm.governor) {
      const auto kept = static_cast<float>(make_group_model(config.groups[s], config).kept * (1.0 + 1e-6));
      room.to_obstacles = std::max(room.to_obstacles, kept);
      room.half_separation = std::max(room.half_separation, kept);
    }
    rooms.push_back(room);
  }
  return rooms;
}

// Why tries were turned down; the largest number names the error.
struct Refusals {
  std::uint32_t obstacle = 0, unreachable = 0, crowded = 0;

  std::string worst(const Room& room) const {
    if (obstacle >= unreachable && obstacle >= crowded) {
      return fmt::format("the region lies inside obstacles, or nearer to them than {:.4g} m{}",
                         room.to_obstacles,
                         room.governed ? ", radius + tube + rounding" : ", the body's radius");
    }
    return unreachable >= crowded ? "no free path leads from the region to the goal"
                                  : "the agents do not fit at their separation";
  }
};

Box bounds_of(const fields::Shape& shape) {
  if (const auto* sphere = std::get_if<fields::SphereShape>(&shape)) {
    return {sphere->center - sphere->radius, sphere->center + sphere->radius};
  }
  return std::get<fields::BoxShape>(shape).box;
}

bool is_inside(const fields::Shape& shape, glm::vec3 p) {
  if (const auto* sphere = std::get_if<fields::SphereShape>(&shape)) {
    const glm::vec3 d = p - sphere->center;
    return d.x * d.x + d.y * d.y + d.z * d.z <= sphere->radius * sphere->radius;
  }
  return bounds_of(shape).contains(p);
}

// Places one swarm; an error where the region is full before all have a place.
Result<void> place_swarm(const Scenario& scenario, const World& world, std::uint32_t index, const Room& room,
                         Taken& taken, std::vector<glm::vec3>& places) {
  const SwarmSpec& swarm = scenario.swarms[index];
  const Box box = bounds_of(swarm.start);
  for (int agent = 0; agent < swarm.count; ++agent) {
    Refusals refusals;
    bool placed = false;
    for (std::uint32_t attempt = 0; attempt < kMostTries && !placed; ++attempt) {
      const glm::vec3 u = draw_unit_cube(
          {scenario.seed, kPlacementStream, index, static_cast<std::uint32_t>(agent), attempt});
      const glm::vec3 p = box.min + u * (box.max - box.min);
      if (!is_inside(swarm.start, p)) {
        continue;
      }
      if (distance_at_start(world, p) < room.to_obstacles) {
        ++refusals.obstacle;
      } else if (world.costs[index] && !world.costs[index]->reaches(p)) {
        ++refusals.unreachable;
      } else if (!taken.is_free(p, room.half_separation)) {
        ++refusals.crowded;
      } else {
        taken.take(p, room.half_separation);
        places.push_back(p);
        placed = true;
      }
    }
    if (!placed) {
      Error error;
      error.message = "swarm '" + swarm.name + "': no place for agent " + std::to_string(agent + 1) + " of " +
                      std::to_string(swarm.count) + " in its start region: " + refusals.worst(room);
      error.place = swarm.start_place;
      return fail(std::move(error));
    }
  }
  return {};
}

// From this many agents on their columns no longer fit the caches near a processor.
constexpr std::size_t kLargeSwarm = 10'000;

// Numbers the agents of a large swarm along the rows of a coarse grid: neighbours in space then start as
// neighbours in memory, and mostly stay so, because a swarm's noise is smooth.
void number_along_rows(std::span<glm::vec3> places, float cell) {
  if (places.size() < kLargeSwarm) {
    return;
  }
  const auto row = [cell](glm::vec3 p) {
    const glm::ivec3 c(glm::floor(p / cell));
    return std::tuple(c.z, c.y, c.x);
  };
  std::stable_sort(places.begin(), places.end(), [&](glm::vec3 a, glm::vec3 b) { return row(a) < row(b); });
}

}  // namespace

tl::expected<std::vector<glm::vec3>, std::vector<Error>> place_agents(const Scenario& scenario,
                                                                      const World& world) {
  const std::vector<Room> rooms = rooms_of(scenario, world);
  float widest = 0.0F;
  for (const Room& room : rooms) {
    widest = std::max(widest, 2.0F * room.half_separation);
  }
  Taken taken(widest);
  std::vector<glm::vec3> places;
  std::vector<Error> errors;
  for (std::uint32_t index = 0; index < scenario.swarms.size(); ++index) {
    const std::size_t first = places.size();
    if (auto placed = place_swarm(scenario, world, index, rooms[index], taken, places); !placed) {
      errors.push_back(std::move(placed.error()));
    }
    number_along_rows(std::span(places).subspan(first), 4.0F * world.grid.cell);
  }
  if (!errors.empty()) {
    return tl::unexpected(std::move(errors));
  }
  return places;
}

}  // namespace mayfly
