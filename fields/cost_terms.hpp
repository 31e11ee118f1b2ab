// What may be added to the cost of a path besides length and nearness to walls: crowds, and a user's brushes.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/grid.hpp"
#include "core/result.hpp"

namespace mayfly::fields {

// Whatever is added, a metre costs at least this share of A: no place is free, and none pays for being
// visited.
inline constexpr float kLeastSlowness = 0.1F;

// Plain inputs of a cost field beyond its parameters: what changes in flight.
struct CostTerms {
  // Cost of a metre that is added to A + B·g in each cell, in the units of A, one value a cell; negative
  // attracts. Empty: nothing is added.
  std::span<const float> extra_slowness;
};

// agents/m³ in each cell, written over `density`. Each agent is spread over 4 × 4 × 4 cells (a linear hat,
// then the binomial ¼ ½ ¼ along each axis), so that densities are continuous in the positions and one agent
// that crosses a cell's face makes nothing flicker. At the borders the spread is mirrored: the sum over cells
// times their volume is the number of agents in the grid. Positions (m) outside, or not a number, do not
// count. One thread, always the same bits; allocates nothing. Errors (kCaller): columns of different lengths,
// a density of another size than the grid.
Result<void> bin_density(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                         const Grid& grid, std::span<float> density);

// extra += weight · density. weight: cost of a metre per agent and m³ (Wang14 §8, its second limitation).
Result<void> add_density(float weight, std::span<const float> density, std::span<float> extra_slowness);

// A place that a user makes dear or cheap: strength · h(|p − center| / radius), h the bell of Wang14 Eq. 6.
struct CostBrush {
  glm::vec3 center{0.0F};
  float radius = 1.0F;    // m, > 0
  float strength = 0.0F;  // cost of a metre added at the centre: above 0 repels, below 0 attracts
};

// extra += the brushes, in their order. Cells beyond a brush's radius stay as they are. Errors (kCaller): a
// brush with numbers that are not finite or a radius that is not positive; a column of another size.
Result<void> add_brushes(std::span<const CostBrush> brushes, const Grid& grid,
                         std::span<float> extra_slowness);

}  // namespace mayfly::fields
