#include "fields/moving_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "core/finite.hpp"
#include "fields/geometry_parts.hpp"
#include "fields/sample_distance.hpp"
#include "fields/spline.hpp"

namespace mayfly::fields {
namespace {

tl::unexpected<Error> refuse(std::string what, std::string found, std::string wanted) {
  return fail(Error{Cause::kCaller, std::move(what), std::nullopt, std::move(found), std::move(wanted), {}});
}

}  // namespace

struct MovingObstacles::State {
  struct Moving {
    Geometry geometry;
    glm::vec3 offset{0.0F};
    float margin = 0.0F;
    CellBox written;  // where it may have lowered the field
  };

  float reach = 0.0F;
  std::vector<float> still;  // capped
  DistanceField field;
  std::vector<float> walls;
  std::vector<Moving> moving;

  void put_back(const CellBox& box) {
    for (int k = box.first.z; k < box.end.z; ++k) {
      for (int j = box.first.y; j < box.end.y && box.first.x < box.end.x; ++j) {
        const std::size_t first = field.grid.index(box.first.x, j, k);
        std::copy_n(still.data() + first, box.end.x - box.first.x, field.distance.data() + first);
      }
    }
  }

  void place(Moving& shape, int threads) {
    shape.written = {glm::ivec3(0), field.grid.cells};
    if (const auto bounds = shape.geometry.parts().bounds()) {
      shape.written = cells_around({bounds->min + shape.offset, bounds->max + shape.offset},
                                   reach + shape.margin, field.grid);
    }
    lower_to_distance(
        shape.geometry,
        {field.grid, shape.written, glm::dvec3(shape.offset), static_cast<double>(shape.margin)}, threads, {},
        field.distance);
  }

  void update(std::span<const glm::vec3> offsets, std::span<const float> margins, int threads) {
    for (Moving& shape : moving) {
      put_back(shape.written);
    }
    for (std::size_t i = 0; i < moving.size(); ++i) {
      moving[i].offset = offsets[i];
      moving[i].margin = margins[i];
      place(moving[i], threads);
    }
    // Wholly: the filter's poles reach across the grid, and this is a matter of nanoseconds a cell.
    fill_spline_coefficients(field.grid, field.distance, threads, walls);
  }
};

MovingObstacles::MovingObstacles(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
MovingObstacles::MovingObstacles(MovingObstacles&&) noexcept = default;
MovingObstacles& MovingObstacles::operator=(MovingObstacles&&) noexcept = default;
MovingObstacles::~MovingObstacles() = default;

Result<MovingObstacles> MovingObstacles::make(DistanceField still, std::span<const PlacedShape> shapes,
                                              float reach, int threads) try {
  if (!(std::isfinite(reach) && reach > 0.0F)) {
    return refuse("the reach of moving obstacles is no length", std::to_string(reach) + " m",
                  "a finite number above 0");
  }
  if (still.distance.size() != still.grid.size()) {
    return refuse("the still obstacles' distance has another size than its grid",
                  std::to_string(still.distance.size()) + " values", std::to_string(still.grid.size()));
  }
  auto state = std::make_unique<State>();
  state->reach = reach;
  state->field = std::move(still);
  for (float& distance : state->field.distance) {
    distance = std::min(distance, reach);
  }
  state->still = state->field.distance;
  state->walls.resize(state->still.size());
  for (const PlacedShape& shape : shapes) {
    auto geometry = Geometry::make({&shape, 1}, state->field.grid.cell);
    if (!geometry) {
      return fail(std::move(geometry.error()));
    }
    state->moving.push_back({std::move(*geometry), glm::vec3(0.0F), 0.0F, {}});
  }
  const std::vector<glm::vec3> at_start(shapes.size(), glm::vec3(0.0F));
  state->update(at_start, std::vector<float>(shapes.size()), threads);
  return MovingObstacles(std::move(state));
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for the field of moving obstacles");
}

Result<void> MovingObstacles::move(std::span<const glm::vec3> offsets, std::span<const float> margins,
                                   int threads) try {
  if (offsets.size() != state_->moving.size() || margins.size() != offsets.size()) {
    return refuse("each moving obstacle needs its offset and its margin",
                  std::to_string(offsets.size()) + " offsets, " + std::to_string(margins.size()) + " margins",
                  std::to_string(state_->moving.size()));
  }
  if (!std::ranges::all_of(margins, [](float m) { return std::isfinite(m) && m >= 0.0F; })) {
    return refuse("an obstacle's margin is no length", {}, "finite metres, not below 0");
  }
  if (!std::ranges::all_of(offsets, [](glm::vec3 a) { return finite(a); })) {
    return refuse("an obstacle's offset is not finite", {}, "metres along x, y, z");
  }
  state_->update(offsets, margins, threads);
  return {};
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory to move an obstacle");
}

const DistanceField& MovingObstacles::field() const noexcept {
  return state_->field;
}
std::span<const float> MovingObstacles::walls() const noexcept {
  return state_->walls;
}

float reach_for(std::span<const float> lengths, const Grid& grid) noexcept {
  float longest = 0.0F;
  for (const float length : lengths) {
    longest = std::max(longest, length);
  }
  return longest + 2.0F * grid.cell;
}

}  // namespace mayfly::fields
