// The smallest distance of any two agents so far, and which agents touch, exactly and every tick.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace mayfly {

// Only pairs nearer than the running minimum can change it, and only pairs nearer than two radii touch: so
// agents are put, one after the other, into hashed cells twice as large as that reach, and each looks at the
// 8 cells that its reach meets. When the minimum has halved, the cells are made anew: no cell ever holds more
// agents than fit at that distance, and a tick costs O(N) from the first one on.
class NearPairs {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // indices of agents, the smaller first

  // `radii` in m, one an agent, finite and ≥ 0. Allocates all that is ever needed.
  explicit NearPairs(std::span<const float> radii);

  // Positions in m, one element an agent; those that are not finite are left out, as is everybody beyond the
  // first radii.size(). Distances are computed in double precision.
  // So is who is 0 in `present`, which is empty where all are there.
  void observe(std::span<const float> x, std::span<const float> y, std::span<const float> z,
               std::span<const std::uint8_t> present = {}) noexcept;

  // m; infinite until two agents were seen at one tick.
  double min_distance() const noexcept;
  // Of the last tick: pairs nearer than the sum of their radii, sorted.
  std::span<const Pair> touching() const noexcept { return touching_; }
  // Encounters: a pair that touches and did not at the tick before.
  std::uint64_t encounters() const noexcept { return encounters_; }
  // Ticks at which more pairs touched than there is room for (8 an agent): the count of encounters is then
  // too low.
  std::uint64_t overflows() const noexcept { return overflows_; }

 private:
  struct Body {
    double x, y, z;
    std::uint32_t agent;
    std::uint32_t next;  // in its cell
  };
  struct Cells {
    std::int64_t low[3];
    std::int64_t high[3];
  };

  void collect(std::span<const float> x, std::span<const float> y, std::span<const float> z,
               std::span<const std::uint8_t> present) noexcept;
  void empty_cells() noexcept;
  void insert(std::uint32_t body) noexcept;
  bool compare_with_cells(std::uint32_t body) noexcept;
  void compare(const Body& a, const Body& b) noexcept;
  void count_encounters() noexcept;
  std::int64_t cell_of(double coordinate) const noexcept;
  std::size_t hash_of(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept;

  std::vector<float> radii_;
  double widest_ = 0.0;  // m, two of the largest radii
  std::vector<Body> bodies_;
  std::vector<std::uint32_t> slots_;  // first body of a cell, one past it; 0 for none
  // One bit for an eighth of a slot: says "nobody there" from the processor's nearest cache.
  std::vector<std::uint64_t> occupied_;
  std::size_t hash_mask_ = 0;
  double reach_ = 0.0;  // m: nothing farther apart matters
  double cells_per_m_ = 0.0;
  double least_squared_ = std::numeric_limits<double>::infinity();
  std::vector<Pair> touching_;
  std::vector<Pair> before_;
  bool overflowed_ = false;
  std::uint64_t encounters_ = 0;
  std::uint64_t overflows_ = 0;
};

}  // namespace mayfly
