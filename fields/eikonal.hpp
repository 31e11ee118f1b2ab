// |∇C| = s on a grid: the cost of the cheapest path from each cell to the nearest source (Wang14 Eq. 7,
// model.md §3).
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>

#include "core/grid.hpp"
#include "core/result.hpp"

namespace mayfly::fields {

// Cost of a cell that no path joins to a source, and of a blocked cell.
inline constexpr float kUnreachedCost = std::numeric_limits<float>::infinity();

struct EikonalStats {
  int sweeps = 0;
  std::uint64_t updates = 0;  // of single cells, the idle lanes included: a measure of the work done
};

// Solves the first-order upwind (Godunov) scheme on six neighbours, by fast sweeping (Zhao 2005), until no
// cell changes.
//
// slowness  cost per metre in each cell, one value a cell of `grid`; a cell is blocked where it is +inf or ≤
// 0. cost      in: the fixed cost of each source cell (may be negative), +inf in every other cell;
//           out: C in every cell, +inf where blocked or unreachable. A source on a blocked cell does not
//           count.
// threads   how many to use; 0 means all of the machine's. The result has the same bits for any number:
// threads work on
//           different planes of the same sweep, but each cell waits for those that come before it in the
//           sweep.
// progress  called from the calling thread with the number of sweeps done. May be empty.
//
// Fails, with cause kCaller, if a span has another size than the grid, if the cell side is not a positive
// number, or if an input is NaN, −inf, or too large for float arithmetic (|cost| ≤ 1e12, slowness · cell ≤
// 1e12).
Result<EikonalStats> solve_eikonal(const Grid& grid, std::span<const float> slowness, std::span<float> cost,
                                   unsigned threads = 0, const std::function<void(int)>& progress = {});

// The same, for a grid that is solved again and again: the tables are asked for once.
class EikonalSolver {
 public:
  // Throws std::bad_alloc. The grid must be one that solve_eikonal takes.
  explicit EikonalSolver(const Grid& grid);
  EikonalSolver(EikonalSolver&&) noexcept;
  EikonalSolver& operator=(EikonalSolver&&) noexcept;
  ~EikonalSolver();

  // As solve_eikonal; on one thread it asks for no memory.
  Result<EikonalStats> solve(std::span<const float> slowness, std::span<float> cost, unsigned threads,
                             const std::function<void(int)>& progress = {});

 private:
  class Sweeper;
  std::unique_ptr<Sweeper> sweeper_;
};

}  // namespace mayfly::fields
