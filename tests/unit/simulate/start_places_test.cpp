// Who starts where he should not.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "simulate/sabotage.hpp"

namespace mayfly::simulate {
namespace {

Scenario with(FaultKind kind, double size, glm::vec3 direction) {
  Scenario scenario;
  scenario.world.bounds = {glm::vec3(0.0F), glm::vec3(10.0F, 20.0F, 5.0F)};
  FaultSpec fault;
  fault.kind = kind;
  fault.size = size;
  fault.direction = direction;
  fault.agents = {{2, 1}, {0, 1}};
  scenario.faults = {fault};
  return scenario;
}

const std::vector<glm::vec3> kPlaces{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};

TEST(StartPlaces, TheSecondStartsTooNearToTheFirst) {
  const auto moved = start_places(with(FaultKind::kStartTooNear, 0.25, {0, 1, 0}), kPlaces);
  EXPECT_EQ(moved[0], glm::vec3(3, 3.25F, 3));
  EXPECT_EQ(moved[1], kPlaces[1]);
  EXPECT_EQ(moved[2], kPlaces[2]);
}

TEST(StartPlaces, OutsideIsBeyondTheWallThatIsPointedAt) {
  const auto high = start_places(with(FaultKind::kStartOutside, 0.5, {0.6F, 0.8F, 0}), kPlaces);
  EXPECT_EQ(high[2], glm::vec3(3, 20.5F, 3));
  EXPECT_EQ(high[0], glm::vec3(1, 20.5F, 1));
  EXPECT_EQ(high[1], kPlaces[1]);
  const auto low = start_places(with(FaultKind::kStartOutside, 0.5, {-1, 0, 0}), kPlaces);
  EXPECT_EQ(low[2], glm::vec3(-0.5F, 3, 3));
}

}  // namespace
}  // namespace mayfly::simulate
