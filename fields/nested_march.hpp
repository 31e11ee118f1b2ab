// Costs on a nested grid, spread from the cells where they are known. For nested_cost.cpp only.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <queue>
#include <span>
#include <vector>

#include "core/nested_grid.hpp"
#include "core/progress.hpp"
#include "fields/nested_sight.hpp"

namespace mayfly::fields {

// Where the straight part of a cheapest path begins, and what it costs from there (A = 1, m).
struct Ray {
  glm::vec3 from{0.0F};
  float cost = 0.0F;
};

// What is known of the costs: tables of one value an entry of the nested grid, apart from `rays`.
struct NestedCosts {
  const NestedGrid& nested;
  std::span<const float> distance;  // φ, m
  std::vector<float> cost;          // C/A, m; +inf where nothing is known
  std::vector<std::uint8_t> fixed;  // 1: exact, not to be changed
  std::vector<Ray> rays;            // one a coarse cell: of those without a brick
};

// Cost per metre at a distance φ, A = 1: 1 + B/A · h(φ/influence) (Wang14 Eqs. 6 and 7).
struct Slowness {
  float repulsion = 0.0F;  // B/A
  float inverse_influence = 1.0F;
  float clearance = 0.0F;  // m; blocked where φ is less

  float at(float phi) const;
};

// Label correcting by blocks, a block being a coarse cell: cheapest first, each is solved from what its
// neighbours know, and wakes those whom a lower cost concerns, until nothing changes by more than a
// five-thousandth of a cell. In bricks: the first-order upwind scheme of fields/eikonal.hpp on fine cells. In
// coarse cells, where a metre costs a metre: straight lines to the point where a neighbour's path last bent,
// so that costs there have no error of the scheme, however far they have come. A single thread: the same
// bits always.
class NestedMarch {
 public:
  NestedMarch(NestedCosts& costs, const Slowness& slowness, const NestedSight& sight);
  void run(const Progress& progress);

 private:
  static constexpr int kSide = NestedGrid::kBrickSide;
  struct Wake {
    float key;
    int block;
    bool operator<(const Wake& other) const {
      return key > other.key || (key == other.key && block > other.block);
    }
  };

  void wake_around_sources();
  void wake(glm::ivec3 at, float key);
  glm::ivec3 place(int block) const;
  float least_fixed(glm::ivec3 at) const;

  // Of bricks.
  void relax_brick(glm::ivec3 at);
  void read_apron(glm::ivec3 at, std::span<float> cost) const;
  float apron_cost(glm::ivec3 neighbour, glm::ivec3 local, glm::vec3 p) const;
  void sweep(std::span<float> cost, std::span<const float> phi, std::span<const std::uint8_t> fixed) const;
  void tell_neighbours(glm::ivec3 at, std::span<const float> before, std::span<const float> after);

  // Of coarse cells.
  struct Best {
    glm::vec3 center;
    float cost;
    Ray ray;
  };
  void relax_leaf(glm::ivec3 at);
  void tell_from_leaf(glm::ivec3 at, glm::ivec3 step);
  void through_leaf(glm::ivec3 neighbour, bool face, Best& best) const;
  void through_brick(glm::ivec3 neighbour, glm::ivec3 step, Best& best) const;
  void straighten(glm::ivec3 neighbour, glm::ivec3 local, Best& best) const;
  void offer(const Ray& ray, Best& best) const;

  NestedCosts& in_;
  Slowness slowness_;
  const NestedSight& sight_;
  float least_change_;
  std::vector<float> waiting_;  // one a block: the key under which it waits, +inf if it does not
  std::priority_queue<Wake> queue_;
  std::size_t relaxed_ = 0;
};

}  // namespace mayfly::fields
