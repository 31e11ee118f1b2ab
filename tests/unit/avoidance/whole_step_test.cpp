// A whole step of the engine against the reference: neighbours by looking at everybody, half-spaces from the
// paper, the best velocity by trying all.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/reference/orca_reference.hpp"
#include "tests/unit/avoidance/open_field.hpp"

namespace mayfly {
namespace {

using reference::HalfSpace;
using reference::Vec;
using test::OpenField;

constexpr std::size_t kAgents = 240;

Vec vec(glm::vec3 v) {
  return {double{v.x}, double{v.y}, double{v.z}};
}

// Three swarms of unlike bodies and habits in a cube, two of which avoid collisions.
struct Mixed {
  OpenField field;

  Mixed() : field(places(3), places(4)) {
    field.swarms.clear();
    for (std::size_t s = 0; s < 3; ++s) {
      field.swarms.push_back(field.swarm(80 * s, 80));
    }
    field.swarms[0].avoidance = {1, 0.15F, 2.0F, 0.5F, 2.0F, 10, 1.5F, 0};
    field.swarms[1].avoidance = {1, 0.25F, 1.0F, 0.5F, 1.5F, 6, 1.2F, 0};
    field.swarms[2].avoidance.on = 0;
    field.swarms[2].field.radius = 0.1F;
    std::mt19937 engine(5);
    std::normal_distribution<float> speed(0, 0.4F);
    for (std::size_t a = 0; a < kAgents; ++a) {
      field.velocity.set(a, {speed(engine), speed(engine), speed(engine)});
    }
  }

  static std::vector<glm::vec3> places(unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> coordinate(-2.8F, 2.8F);
    std::vector<glm::vec3> all(kAgents);
    for (glm::vec3& place : all) {
      place = {coordinate(engine), coordinate(engine), coordinate(engine)};
    }
    return all;
  }

  const SwarmModel& swarm_of(std::size_t agent) const { return field.swarms[agent / 80]; }
  double radius_of(std::size_t agent) const {
    const SwarmModel& swarm = swarm_of(agent);
    return swarm.avoidance.on != 0 ? double{swarm.avoidance.radius} : double{swarm.field.radius};
  }

  std::vector<HalfSpace> half_spaces(std::size_t self) const {
    const kernels::MfAvoidance& a = swarm_of(self).avoidance;
    std::vector<std::pair<double, std::size_t>> near_ones;
    for (std::size_t other = 0; other < kAgents; ++other) {
      const double distance = reference::norm(vec(field.at.at(other)) - vec(field.at.at(self)));
      if (other != self && distance <= double{a.range}) {
        near_ones.emplace_back(distance, other);
      }
    }
    std::sort(near_ones.begin(), near_ones.end());
    near_ones.resize(std::min(near_ones.size(), static_cast<std::size_t>(a.neighbours)));
    std::vector<HalfSpace> planes;
    for (const auto& [distance, other] : near_ones) {
      const reference::Pair pair{vec(field.at.at(other)) - vec(field.at.at(self)),
                                 vec(field.velocity.at(self)), vec(field.velocity.at(other)),
                                 radius_of(self) + radius_of(other)};
      planes.push_back(orca_half_space(pair, swarm_of(other).avoidance.on != 0 ? 0.5 : 1.0, double{a.horizon},
                                       double{OpenField::kPeriod}));
    }
    return planes;
  }
};

TEST(Avoidance, FliesTheBestVelocityOfTheReference) {
  const Mixed before;
  OpenField wished = before.field;
  OpenField flown = before.field;
  for (OpenField* field : {&wished, &flown}) {
    for (std::size_t s = 0; s < 3; ++s) {
      field->swarms[s] = field->swarm(80 * s, 80);
      field->swarms[s].avoidance = before.field.swarms[s].avoidance;
      field->swarms[s].avoidance.on = field == &flown ? before.field.swarms[s].avoidance.on : 0;
      field->swarms[s].field.radius = before.field.swarms[s].field.radius;
    }
    const auto engine = make_native_engine(1);
    ASSERT_TRUE(engine->prepare(field->swarms, kAgents));
    field->fly(*engine, 1);
  }
  std::size_t infeasible = 0;
  std::size_t changed = 0;
  for (std::size_t a = 0; a < kAgents; ++a) {
    const Vec wish = vec(wished.velocity.at(a));
    const Vec v = vec(flown.velocity.at(a));
    if (before.swarm_of(a).avoidance.on == 0) {
      EXPECT_EQ(flown.velocity.at(a), wished.velocity.at(a));
      continue;
    }
    const reference::BestVelocity reference(before.half_spaces(a),
                                            double{before.swarm_of(a).avoidance.most_speed});
    const auto best = reference.nearest(wish, 1e-9);
    if (!best) {
      ++infeasible;
      EXPECT_LE(reference.violation(v, 0), reference.least_violation(0) + 1e-3) << a;
      continue;
    }
    EXPECT_LE(reference.violation(v, 0), 1e-3) << a;
    // A barred wish leans to the side, by 3 % of the speed and a little up or down.
    const double lean = 0.0425 * reference::norm(wish);
    EXPECT_LE(reference::norm(v - wish), reference::norm(*best - wish) + 2 * lean + 1e-4) << a;
    changed += reference::norm(v - wish) > 1e-3 ? 1U : 0U;
  }
  EXPECT_EQ(flown.infeasible, infeasible);
  EXPECT_GT(infeasible, 3U);
  EXPECT_GT(changed, 50U);
}

}  // namespace
}  // namespace mayfly
