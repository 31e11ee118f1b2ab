// Who may be near whom in a tick: agents sorted into cells, without allocating.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/grid.hpp"

namespace mayfly {

class NeighbourCells {
 public:
  // What one agent may need in a tick lies within a ball.
  struct Ball {
    glm::dvec3 center{0.0};
    double radius = -1.0;  // m; negative: it needs nothing, and is nobody's neighbour
  };

  // `usual`: m, what a ball's radius rarely exceeds; larger ones cost a look by everybody.
  NeighbourCells(std::size_t agents, const Box& box, double usual);

  void sort(std::span<const Ball> balls) noexcept;
  // All others whose balls touch the agent's. Good until the next call.
  std::span<const std::uint32_t> near(std::size_t agent, std::span<const Ball> balls) noexcept;

 private:
  int cell_along(double coordinate, int axis) const noexcept;
  std::size_t cell_of(glm::dvec3 place) const noexcept;
  void look_at(std::span<const std::uint32_t> others, std::size_t agent,
               std::span<const Ball> balls) noexcept;

  double usual_;
  glm::dvec3 origin_;
  glm::dvec3 side_{0.0};  // m, of a cell: two usual balls at least
  glm::ivec3 cells_{1};
  std::vector<std::uint32_t> starts_;   // of each cell in `sorted_`, and one more
  std::vector<std::uint32_t> sorted_;   // agents by cell
  std::vector<std::uint32_t> cell_of_;  // one an agent
  std::vector<std::uint32_t> wide_;     // agents with unusual balls
  std::vector<std::uint32_t> found_;
  std::size_t sorted_count_ = 0, wide_count_ = 0, found_count_ = 0;
};

}  // namespace mayfly
