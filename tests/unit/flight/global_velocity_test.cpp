// The guided part of the field model, on a real cost field: kernels/field.h, mf_global_velocity.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "controller/flight/swarm_models.hpp"
#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

constexpr glm::vec3 kRest{6.0F, 15.0F, 6.0F};

// Fields of a hall with a wall and a gap; the goal's near face is at y = 12 m.
class GlobalVelocity : public ::testing::Test {
 protected:
  glm::vec3 at(glm::vec3 p, glm::vec3 rest = kRest) const {
    const auto lanes = [](glm::vec3 v) { return kernels::mf3_splat(v.x, v.y, v.z); };
    const kernels::MfAround around = kernels::mf_around(lanes(p), world_.walls.data(), &field_.grid);
    const kernels::MfTables tables{nullptr, world_.costs[0]->guide.data(), &rest.x, &rest.y, &rest.z,
                                   nullptr};
    kernels::F cost{};
    const kernels::F3 v =
        kernels::mf_global_velocity(lanes(p), kernels::mf_isplat(0), &around, &field_, &tables, &cost);
    return {v.x[0], v.y[0], v.z[0]};
  }
  glm::vec3 direction(glm::vec3 p) const { return glm::normalize(at(p)); }

  World world_ = world_of(walled_hall(1));
  kernels::MfField field_ = make_swarm_models(walled_hall(1), world_).swarms[0].field;
};

TEST_F(GlobalVelocity, IsTheCruiseSpeedEverywhereOutsideTheGoal) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> u(0.0F, 1.0F);
  int tried = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::vec3 p{12 * u(engine), 20 * u(engine), 12 * u(engine)};
    // Half a cell around the goal the interpolated depth is not yet that of the surface.
    const bool near_goal = p.x > 1 && p.x < 11 && p.y > 11 && p.y < 19 && p.z > 1 && p.z < 11;
    if (near_goal || world_.solid.signed_distance(p) < 0.05F) {
      continue;
    }
    EXPECT_NEAR(glm::length(at(p)), 1.5F, 1e-4F) << p.x << ' ' << p.y << ' ' << p.z;
    ++tried;
  }
  EXPECT_GT(tried, 1000);
}

TEST_F(GlobalVelocity, IsNoneAtAPlaceOfRestThatLiesDeepEnough) {
  for (const glm::vec3 rest : {kRest, glm::vec3(5, 14.5F, 7), glm::vec3(7.3F, 15.1F, 5.2F)}) {
    EXPECT_LT(glm::length(at(rest, rest)), 1e-3F);
  }
}

TEST_F(GlobalVelocity, SlowsDownTowardsTheRestAndPointsThere) {
  float last = 0.0F;
  for (const float away : {0.01F, 0.1F, 0.5F, 1.0F, 1.4F}) {
    const glm::vec3 v = at(kRest - glm::vec3(0, away, 0));
    EXPECT_GT(v.y, 0.99F * glm::length(v)) << away;
    EXPECT_GT(glm::length(v), last) << away;
    EXPECT_LE(glm::length(v), 1.5F * (1 + 1e-5F)) << away;
    last = glm::length(v);
  }
  // The ramp's slope at 0 is 15/8 (Wang14 Eq. 3).
  EXPECT_NEAR(glm::length(at(kRest - glm::vec3(0, 0.01F, 0))), 1.5F * 1.875F * 0.01F / field_.slow_down,
              1e-3F);
}

TEST_F(GlobalVelocity, IsANumberWhereverAnAgentIsEvenAtItsRest) {
  std::mt19937 engine(2);
  std::uniform_real_distribution<float> u(-2.0F, 22.0F);  // also outside the grid, and in the walls
  for (int i = 0; i < 5000; ++i) {
    const glm::vec3 p{u(engine), u(engine), u(engine)};
    for (const glm::vec3 rest : {p, kRest, p + 1e-30F, glm::vec3(1e6F)}) {
      const glm::vec3 v = at(p, rest);
      ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
      ASSERT_LE(glm::length(v), 1.5F * (1 + 1e-4F));
    }
  }
}

// Along lines through the goal's face: finer steps make proportionally smaller turns.
TEST_F(GlobalVelocity, TurnsWithoutAJumpThroughTheGoalsSurface) {
  const auto sharpest = [&](float step) {
    float most = 0.0F;
    for (const float x : {3.0F, 4.3F, 6.0F, 7.9F, 9.0F}) {
      for (float y = 11.0F; y < 12.5F; y += step) {
        const glm::vec3 turn = at({x, y + step, 5.0F}) - at({x, y, 5.0F});
        most = std::max(most, glm::length(turn));
      }
    }
    return most;
  };
  const float coarse = sharpest(1.0F / 64);
  const float fine = sharpest(1.0F / 256);
  EXPECT_LT(coarse, 0.2F);
  EXPECT_LT(fine, 0.35F * coarse);
}

TEST_F(GlobalVelocity, LeadsThroughTheGap) {
  EXPECT_GT(direction({6, 8, 6}).y, 0.99F);
  EXPECT_GT(direction({2, 6, 6}).x, 0.5F) << "left of it, to the right";
  EXPECT_LT(direction({10, 6, 6}).x, -0.5F) << "right of it, to the left";
}

TEST_F(GlobalVelocity, LeadsIntoTheGoalAtItsSurfaceWhereverTheRestIs) {
  for (const glm::vec3 rest : {kRest, glm::vec3(3, 13, 3), glm::vec3(9, 17, 9)}) {
    EXPECT_GT(at({6, 11.9F, 6}, rest).y, 0.0F);
  }
}

}  // namespace
}  // namespace mayfly::test
