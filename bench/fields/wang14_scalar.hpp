// The baseline: Wang et al. 2014 as the paper prints it, in plain scalar C++, one agent after the other.
// Nothing of the product is in it but the grid's type, and nothing of it is in the product.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/grid.hpp"

namespace mayfly::bench {

struct Wang14Parameters {
  float scale = 0.6F;         // m
  float gain = 1.0F;          // m²/s
  float cruise_speed = 8.0F;  // m/s, s0
  float min_distance = 0.1F;  // m
  int mde_sweeps = 8;         // at most, a step
  // The paper keeps its potential N on a grid ("typically, the noise field needs a higher resolution grid").
  // Tabulated on cells of the cost's own side it loses what is finer than a cell; evaluated at the agent it
  // does not, as the product does it.
  bool tabulated = false;
};

class Wang14Scalar {
 public:
  // distance (m, negative inside) and cost: one value a cell of `grid`; cost is +inf where nobody may fly.
  Wang14Scalar(const Grid& grid, std::span<const float> distance, std::span<const float> cost,
               const Wang14Parameters& parameters);

  void place(std::span<const glm::vec3> agents) { at_.assign(agents.begin(), agents.end()); }
  std::span<const glm::vec3> agents() const { return at_; }

  // Eq. 9 at r: curl of Eq. 2's potential, and the cruise speed down the cost's slope.
  glm::vec3 velocity(glm::vec3 r) const;
  // One frame: every agent moves by its velocity times dt (s), then minimum distance enforcement over the
  // pairs in each cell. Returns how many agents were moved by it.
  std::size_t step(float dt);

 private:
  void tabulate();
  float sample(std::span<const float> column, glm::vec3 r) const;
  float cost_near(glm::vec3 r, float fallback) const;
  float noise(int which, glm::vec3 q) const;
  glm::vec3 potential(glm::vec3 r) const;
  glm::vec3 tabulated_potential(glm::vec3 r) const;
  glm::vec3 curl(glm::vec3 r) const;
  glm::vec3 downhill(glm::vec3 r) const;
  std::size_t cell_of(glm::vec3 r) const;
  bool part_pairs();

  Grid grid_;
  std::span<const float> distance_, cost_;
  Wang14Parameters parameters_;
  std::array<std::array<int, 512>, 3> permutation_{};
  std::array<std::vector<float>, 3> table_;  // N a cell, where tabulated
  std::vector<glm::vec3> at_;
  std::vector<int> head_, next_;  // the agents of each cell, as linked lists
  std::vector<std::uint8_t> moved_;
};

}  // namespace mayfly::bench
