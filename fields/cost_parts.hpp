// The steps of which a cost field is made; for cost_field.cpp and cost_solver.cpp only.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/grid.hpp"
#include "core/progress.hpp"
#include "core/result.hpp"
#include "fields/cost_field.hpp"

namespace mayfly::fields {

// Of a metre's extra cost, either way.
inline constexpr float kLargestExtra = 1e6F;

glm::vec3 center_of(const Grid& grid, std::size_t cell);

// m: the default is Wang14's 2a.
float influence_of(const CostParams& params, const Grid& grid);

Result<void> check_params(const CostParams& params);
Result<void> check_terms(const CostTerms& terms, const Grid& grid);

// Cost of a metre over A in cells [first, end): 1 + (B·g + extra)/A (Wang14 Eq. 7 with weights), no less than
// kLeastSlowness, +inf where blocked. With A = 1, costs come out as C/A, for A + B·g and A·φ_goal scale
// together.
void fill_slowness(std::span<const float> distance, const CostTerms& terms, const CostParams& params,
                   const Grid& grid, std::size_t first, std::size_t end, std::span<float> slowness);

// The kind of each cell by φ and by whether its cost (one in `stride` of the values) is below `unreached`,
// and how many there are.
void set_kinds(std::span<const float> distance, std::span<const float> cost, std::size_t stride,
               float unreached, float clearance, CostField& field);

// A goal that holds no cell centre: its sources, which point at its middle (if it has one). Otherwise no
// cells.
struct SmallGoal {
  std::span<const std::size_t> cells;
  std::optional<glm::vec3> middle;
};

// Kinds, counts and guide from solved costs. Allocates nothing where `field` has its sizes already.
void finish_cost_field(std::span<const float> distance, std::span<const float> cost, const CostParams& params,
                       const SmallGoal& small, int threads, const Progress& progress, CostField& field);

}  // namespace mayfly::fields
