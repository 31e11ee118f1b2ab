// Worlds small enough for a dense grid of the same fine cells.
#pragma once

#include <gtest/gtest.h>

#include <glm/vec3.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "fields/nested_cost.hpp"
#include "fields/nested_distance.hpp"

namespace mayfly::fields::test {

inline Shape box(glm::vec3 min, glm::vec3 max) {
  return BoxShape{{min, max}};
}

inline Geometry geometry(const std::vector<Shape>& shapes) {
  std::vector<PlacedShape> placed;
  for (const Shape& shape : shapes) {
    placed.push_back({shape, {}});
  }
  return std::move(*Geometry::make(placed, 1.0F));
}

inline constexpr BrickReach kReach{5.0F, 2.0F, 3.0F};

struct NestedWorld {
  Box bounds;
  Shape goal;
  std::vector<Geometry> goals;
  Geometry solid;
  std::shared_ptr<const NestedGrid> nested;
  std::vector<float> distance;
  std::vector<float> walls;

  Result<CostField> cost(const CostParams& params = {}, int threads = 2) const {
    return build_nested_cost({nested, distance}, goals[0], params, threads, {});
  }
};

inline NestedWorld make_world(const std::vector<Shape>& obstacles, const Shape& goal, glm::vec3 size,
                              int threads = 2) {
  std::vector<Geometry> goals;
  goals.push_back(geometry({goal}));
  Geometry solid = geometry(obstacles);
  const Box bounds{glm::vec3(0.0F), size};
  auto field = build_nested_distance(solid, goals, bounds, 1.0F, kReach, threads, {});
  EXPECT_TRUE(field) << (field ? "" : field.error().message);
  std::vector<float> walls = nested_walls(*field, threads, {});
  auto nested = std::make_shared<const NestedGrid>(std::move(field->nested));
  return {bounds,
          goal,
          std::move(goals),
          std::move(solid),
          std::move(nested),
          std::move(field->distance),
          std::move(walls)};
}

// Two walls with a slit of 3 m and a tower, between which a coarse cell of 8 m leaves no way.
inline std::vector<Shape> slit() {
  return {box({60, -1, -1}, {64, 62, 97}), box({60, 65, -1}, {64, 129, 97}),
          box({90, 40, -1}, {104, 54, 60})};
}
inline const glm::vec3 kSlitSize{128, 128, 96};
inline Shape slit_goal() {
  return box({110, 56, 40}, {120, 72, 56});
}

}  // namespace mayfly::fields::test
