#include "bench/noise/arena.hpp"

#include <utility>

#include "controller/engine/permutation.hpp"
#include "controller/flight/kernel_parts.hpp"
#include "controller/flight/scatter.hpp"
#include "controller/flight/swarm_models.hpp"

namespace mayfly::bench {
namespace {

constexpr std::uint32_t kStartStream = 0xBE7C0001U;
constexpr std::uint32_t kNoiseStream = 0xBE7C0002U;

Scenario two_blocks() {
  Scenario scenario;
  scenario.name = "two_blocks_passage";
  scenario.world.bounds = {{0, 0, 0}, {60, 112, 40}};
  for (const float x : {0.0F, 36.0F}) {
    scenario.world.obstacles.push_back({fields::BoxShape{{{x, 48, -2}, {x + 24, 64, 42}}}, {}});
  }
  GoalSpec goal;
  goal.name = "exit";
  goal.shape = fields::BoxShape{{{20, 100, 10}, {40, 110, 30}}};
  scenario.world.goals = {goal};
  SwarmSpec swarm;
  swarm.name = "flies";
  swarm.count = 1;
  swarm.start = fields::BoxShape{{{20, 4, 10}, {40, 14, 30}}};
  swarm.goal = goal.name;
  swarm.cruise_speed = 1.5F;
  swarm.limits = {6.0F, 2000.0F, 0.0F};
  scenario.swarms = {swarm};
  return scenario;
}

}  // namespace

kernels::MfTables Arena::tables() const {
  static constexpr float kRest[3] = {30.0F, 105.0F, 20.0F};  // m, the goal's middle
  return {world.walls.data(), world.costs[0]->guide.data(), &kRest[0], &kRest[1],
          &kRest[2],          kPermutation.data()};
}

std::vector<glm::vec3> Arena::starts(std::size_t agents, std::uint64_t seed) const {
  const Box& box = std::get<fields::BoxShape>(scenario.swarms[0].start).box;
  std::vector<glm::vec3> places;
  for (std::uint32_t a = 0; a < agents; ++a) {
    places.push_back(box.min + (box.max - box.min) * draw_unit_cube({seed, kStartStream, 0, a, 0}));
  }
  return places;
}

kernels::MfNoise Arena::noise(NoiseKind kind, std::uint64_t seed) const {
  NoiseSpec spec = scenario.swarms[0].noise;
  spec.kind = kind;
  return kernel_noise(spec, draw_words({seed, kNoiseStream, 0, 0, 0})[0]);
}

tl::expected<Arena, std::vector<Error>> make_arena() {
  const Scenario scenario = two_blocks();
  auto world = build_world(scenario, 0, {});
  if (!world) {
    return tl::unexpected(std::move(world.error()));
  }
  kernels::MfField field = make_swarm_models(scenario, *world).swarms[0].field;
  field.has_noise = 0;
  return Arena{scenario, std::move(*world), field};
}

}  // namespace mayfly::bench
