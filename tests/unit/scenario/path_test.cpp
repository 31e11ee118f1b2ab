// Where a moving shape is: by short steps along the path, which no leg or lap is known to.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "controller/scenario/scenario.hpp"

namespace mayfly {
namespace {

double distance(glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 d = a - b;
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

// Where somebody is who walks `left` metres from point to point.
glm::dvec3 walked(const PathSpec& path, double left) {
  glm::dvec3 at(path.points[0]);
  for (std::size_t next = 1;; ++next) {
    if (next >= path.points.size() && !path.loop) {
      return at;
    }
    const glm::dvec3 to(path.points[next % path.points.size()]);
    const double leg = distance(at, to);
    if (leg > left) {
      return at + (to - at) * (left / leg);
    }
    left -= leg;
    at = to;
  }
}

PathSpec triangle(bool loop) {
  PathSpec path;
  path.points = {{1.0F, 2.0F, 3.0F}, {4.0F, 2.0F, 3.0F}, {4.0F, 6.0F, 3.0F}, {4.0F, 6.0F, 3.0F}};
  path.speed = 0.7F;
  path.loop = loop;
  return path;
}

TEST(Path, GoesAsOneWouldWalkIt) {
  for (const bool loop : {false, true}) {
    const PathSpec path = triangle(loop);
    for (double time = 0.0; time < 60.0; time += 0.173) {
      const glm::dvec3 wanted =
          walked(path, time * static_cast<double>(path.speed)) - glm::dvec3(path.points[0]);
      EXPECT_LT(distance(glm::dvec3(path.displacement(time)), wanted), 1e-5) << loop << " " << time;
    }
  }
}

TEST(Path, NeverJumpsAndMovesAsItsVelocitySays) {
  constexpr double kStep = 1e-3;
  for (const bool loop : {false, true}) {
    const PathSpec path = triangle(loop);
    for (double time = 0.0; time < 40.0; time += kStep) {
      const glm::dvec3 moved =
          glm::dvec3(path.displacement(time + kStep)) - glm::dvec3(path.displacement(time));
      EXPECT_LE(distance(moved, glm::dvec3(0.0)), kStep * static_cast<double>(path.speed) + 2e-6) << time;
    }
  }
  EXPECT_LT(distance(glm::dvec3(triangle(false).velocity(1.0)), {0.7, 0.0, 0.0}), 1e-6);
  EXPECT_LT(distance(glm::dvec3(triangle(false).velocity(5.0)), {0.0, 0.7, 0.0}), 1e-6);
}

TEST(Path, StaysAtItsEndOrStartsAgain) {
  const glm::dvec3 end(3.0, 4.0, 0.0);
  EXPECT_LT(distance(glm::dvec3(triangle(false).displacement(1e9)), end), 1e-6);
  EXPECT_EQ(triangle(false).velocity(1e9), glm::vec3(0.0F));
  const double lap = 12.0 / static_cast<double>(0.7F);
  EXPECT_LT(distance(glm::dvec3(triangle(true).displacement(1000.0 * lap + 1.0)),
                     glm::dvec3(triangle(true).displacement(1.0))),
            1e-5);
}

TEST(Path, NoTimeBeforeTheStartAndNoPointsAreNoMotion) {
  EXPECT_EQ(triangle(true).displacement(-1.0), glm::vec3(0.0F));
  EXPECT_EQ(triangle(true).displacement(std::numeric_limits<double>::quiet_NaN()), glm::vec3(0.0F));
  EXPECT_EQ(PathSpec{}.displacement(3.0), glm::vec3(0.0F));
  EXPECT_EQ(PathSpec{}.velocity(3.0), glm::vec3(0.0F));
  PathSpec still;
  still.points = {glm::vec3(5.0F), glm::vec3(5.0F)};
  still.loop = true;
  EXPECT_EQ(still.displacement(3.0), glm::vec3(0.0F));
  EXPECT_EQ(still.velocity(3.0), glm::vec3(0.0F));
}

TEST(Path, OutsideIsWhereAnyPartOfTheShapeIs) {
  PathSpec path;
  path.points = {glm::vec3(0.0F), {1.0F, 0.0F, 0.0F}, {1.0F, 0.0F, -1.5F}};
  const Box bounds{glm::vec3(0.0F), glm::vec3(10.0F)};
  EXPECT_FALSE(path.first_point_outside({{2.0F, 2.0F, 2.0F}, {9.0F, 3.0F, 3.0F}}, bounds));
  EXPECT_EQ(path.first_point_outside({{2.0F, 2.0F, 2.0F}, {9.1F, 3.0F, 3.0F}}, bounds), 1U);
  EXPECT_EQ(path.first_point_outside({{2.0F, 2.0F, 1.0F}, {9.0F, 3.0F, 3.0F}}, bounds), 2U);
  EXPECT_EQ(path.first_point_outside({{-1.0F, 2.0F, 2.0F}, {1.0F, 3.0F, 3.0F}}, bounds), 0U);
}

}  // namespace
}  // namespace mayfly
