// Whatever is desired, nothing is broken: the governor against an independent plant in double precision.
#include <cmath>
#include <limits>
#include <random>

#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

constexpr double kPeriod = 0.01;

// How a robot's velocity plant its command.
enum class Plant { kLinearly, kAtOnce, kFaster, kLagging };

struct Robot {
  glm::dvec3 p{0.0}, v{0.0};
};

// The exact solution after a share of a tick in which the command has been w.
Robot advance(const Robot& r, glm::dvec3 w, Plant plant, double time) {
  const double lag = 0.1;
  switch (plant) {
    case Plant::kAtOnce:
      return {r.p + time * w, w};
    case Plant::kLagging: {
      const double left = std::exp(-time / lag);
      return {r.p + time * w + lag * (1.0 - left) * (r.v - w), w + left * (r.v - w)};
    }
    default: {
      const double ramp = plant == Plant::kFaster ? 0.4 * kPeriod : kPeriod;
      if (time <= ramp) {
        return {r.p + time * r.v + time * time / (2.0 * ramp) * (w - r.v), r.v + time / ramp * (w - r.v)};
      }
      return {r.p + 0.5 * ramp * (r.v + w) + (time - ramp) * w, w};
    }
  }
}

// Two spheres and a slab that leave narrow ways between them, in a box of 8 × 6 × 4 m.
double world_distance(glm::dvec3 p) {
  const double first = glm::length(p - glm::dvec3(2.5, 3.0, 2.0)) - 0.9;
  const double second = glm::length(p - glm::dvec3(5.5, 2.5, 1.5)) - 1.1;
  const glm::dvec3 q = glm::abs(p - glm::dvec3(4.0, 5.0, 2.0)) - glm::dvec3(1.5, 0.1, 2.5);
  const double slab =
      glm::length(glm::max(q, glm::dvec3(0.0))) + std::fmin(std::fmax(q.x, std::fmax(q.y, q.z)), 0.0);
  return std::fmin(first, std::fmin(second, slab));
}

struct Course {
  Grid grid{{0, 0, 0}, 0.25F, {32, 24, 16}};
  std::vector<float> data;
  Course() {
    for (int k = 0; k < grid.cells.z; ++k) {
      for (int j = 0; j < grid.cells.y; ++j) {
        for (int i = 0; i < grid.cells.x; ++i) {
          data.push_back(static_cast<float>(world_distance(glm::dvec3(grid.center(i, j, k)))));
        }
      }
    }
  }
};

class Adversary {
 public:
  explicit Adversary(std::uint64_t seed) : random_(seed) {}

  // Changes its mind every few ticks: jerks, walls, obstacles, and numbers that are none.
  glm::vec3 desire(std::uint64_t tick, std::size_t agent, const Robot& robot) {
    switch ((tick / 150 + agent) % 7) {
      case 0:
        return vector(6.0F);  // a jerk each tick
      case 1:
        return {50.0F, 0.0F, 0.0F};
      case 2:
        return glm::vec3(glm::dvec3(4.0, 3.0, 2.0) - robot.p) *
               10.0F;  // all to the middle, between the obstacles
      case 3:
        return {0.3F, -1e30F, std::numeric_limits<float>::max()};
      case 4:
        return tick % 3 == 0 ? glm::vec3(std::numeric_limits<float>::quiet_NaN()) : vector(2.0F);
      case 5:
        return {tick % 2 == 0 ? std::numeric_limits<float>::infinity() : -2.0F, 2.0F, 0.1F};
      default: {  // down the distance: straight into the nearest obstacle, or along it
        const double h = 1e-4;
        const double here = world_distance(robot.p);
        const glm::dvec3 g(world_distance(robot.p + glm::dvec3(h, 0, 0)) - here,
                           world_distance(robot.p + glm::dvec3(0, h, 0)) - here,
                           world_distance(robot.p + glm::dvec3(0, 0, h)) - here);
        const glm::dvec3 along(-g.y, g.x, 0.1 * g.z);
        return glm::vec3((-g + (agent % 2 == 0 ? 0.0 : 1.0) * along) * (3.0 / h));
      }
    }
  }

  glm::vec3 vector(float size) {
    std::normal_distribution<float> normal(0.0F, size);
    return {normal(random_), normal(random_), normal(random_)};
  }
  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

 private:
  std::mt19937_64 random_;
};

struct Worst {
  double speed = 0.0;         // m/s
  double acceleration = 0.0;  // m/s²
  double fence = 1e9;         // m from the centre to the nearest face
  double obstacle = 1e9;      // m
  double travelled = 0.0;     // m, so that standing still does not pass for being safe
};

// `exact`: the governor may ask for the exact distance. States are handed over as floats, as a HAL does.
Worst attack(Plant plant, bool exact, std::size_t agents, std::uint64_t ticks, std::uint64_t seed) {
  const Course course;
  GovernorConfig config = default_config(agents);
  config.fence = {{0, 0, 0}, {8, 6, 4}};
  config.groups[0].limits.braking = seed % 2 == 0 ? 4.0F : 3.0F;
  config.groups[0].limits.follows =
      plant == Plant::kAtOnce ? mayfly::Follows::kAtOnce : mayfly::Follows::kAccelerating;
  config.groups[0].limits.response_time = plant == Plant::kLagging ? 0.1F : 0.0F;
  config.obstacles.sampled = {course.data.data(), course.grid};
  if (exact) {
    config.obstacles.exact = [](glm::vec3 p) { return static_cast<float>(world_distance(glm::dvec3(p))); };
  }
  Rig rig(config);
  Adversary adversary(seed);
  std::vector<Robot> robots(agents);
  for (Robot& robot : robots) {
    do {
      robot.p = {8.0 * adversary.unit(), 6.0 * adversary.unit(), 4.0 * adversary.unit()};
    } while (world_distance(robot.p) < 0.12 ||
             glm::any(glm::lessThan(glm::min(robot.p, glm::dvec3(8, 6, 4) - robot.p), glm::dvec3(0.11))));
  }
  Worst worst;
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    for (std::size_t i = 0; i < agents; ++i) {
      rig.place(i, glm::vec3(robots[i].p), glm::vec3(robots[i].v));
      rig.desire(i, adversary.desire(tick, i, robots[i]));
      rig.known[i] = (tick / 40 + i) % 50 == 0 ? 0 : 1;
    }
    const std::vector<float> before[] = {rig.ox, rig.oy, rig.oz};
    rig.tick();
    rig.now += 10ms;
    for (std::size_t i = 0; i < agents; ++i) {
      const glm::dvec3 w(rig.command(i));
      const glm::dvec3 last(before[0][i], before[1][i], before[2][i]);
      worst.speed = std::fmax(worst.speed, glm::length(w));
      worst.acceleration = std::fmax(worst.acceleration, glm::length(w - last) / kPeriod);
      for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const glm::dvec3 p = advance(robots[i], w, plant, share * kPeriod).p;
        const glm::dvec3 faces = glm::min(p, glm::dvec3(8, 6, 4) - p);
        worst.fence = std::fmin(worst.fence, std::fmin(faces.x, std::fmin(faces.y, faces.z)));
        worst.obstacle = std::fmin(worst.obstacle, world_distance(p));
      }
      const Robot next = advance(robots[i], w, plant, kPeriod);
      worst.travelled += glm::length(next.p - robots[i].p);
      robots[i] = next;
    }
  }
  return worst;
}

void expect_kept(const Worst& worst, double ticks) {
  EXPECT_LE(worst.speed, 2.0 * (1.0 + 1e-5));
  EXPECT_LE(worst.acceleration, 4.0 * (1.0 + 1e-5));
  EXPECT_GE(worst.fence, 0.1);
  EXPECT_GE(worst.obstacle, 0.1);
  EXPECT_GE(worst.travelled / (ticks * kPeriod), 0.05);  // m/s, mean: it is not simply standing
}

class GovernorHostile : public testing::TestWithParam<Plant> {};

TEST_P(GovernorHostile, NothingBreaksWithTheExactDistance) {
  expect_kept(attack(GetParam(), true, 100, 3000, 1), 3e5);
}

TEST_P(GovernorHostile, NothingBreaksWithTheSampledDistanceOnly) {
  expect_kept(attack(GetParam(), false, 100, 3000, 2), 3e5);
}

std::string name_of(const testing::TestParamInfo<Plant>& info) {
  switch (info.param) {
    case Plant::kLinearly:
      return "Linearly";
    case Plant::kAtOnce:
      return "AtOnce";
    case Plant::kFaster:
      return "Faster";
    default:
      return "Lagging";
  }
}

INSTANTIATE_TEST_SUITE_P(Plants, GovernorHostile,
                         testing::Values(Plant::kLinearly, Plant::kAtOnce, Plant::kFaster, Plant::kLagging),
                         name_of);

}  // namespace
}  // namespace mayfly::governor_test
