#include "fields/cost_solver.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "fields/cost_parts.hpp"
#include "fields/eikonal.hpp"
#include "fields/goal_region.hpp"
#include "fields/make_grid.hpp"
#include "fields/parallel.hpp"

namespace mayfly::fields {

namespace {

// Below this share of cells that can be kept, finding and keeping them costs more than it saves.
constexpr double kWorthKeeping = 0.1;

Result<void> check_offset(glm::vec3 offset) {
  if (!std::isfinite(offset.x) || !std::isfinite(offset.y) || !std::isfinite(offset.z)) {
    return fail(Cause::kCaller, "the goal's offset is not finite");
  }
  return {};
}

}  // namespace

struct CostSolver::State {
  // One solve's arrays, one value a cell.
  struct Solved {
    std::vector<float> slowness, sources, cost;

    explicit Solved(std::size_t cells) : slowness(cells), sources(cells), cost(cells) {}
  };

  State(const Grid& on, GoalRegion region, const CostParams& weights)
      : grid(on),
        params(weights),
        goal(std::move(region)),
        goal_distance(goal.nowhere()),
        last(grid.size()),
        next(grid.size()),
        eikonal(grid) {}

  // The least of the costs in the last solve of cells whose slowness is another now, and of their neighbours.
  // Everything below it stays: in the order of costs, the first cell that can differ is one of these, and it
  // gets its new cost from a neighbour that had its cost before.
  float least_changed_cost() const {
    float least = kUnreachedCost;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      // What a source costs to cross matters to nobody.
      if (last.slowness[cell] != next.slowness[cell] && next.sources[cell] == kUnreachedCost) {
        least = std::min(least, least_around(cell));
      }
    }
    return least;
  }

  float least_around(std::size_t cell) const {
    const auto nx = static_cast<std::size_t>(grid.cells.x);
    const std::size_t plane = nx * static_cast<std::size_t>(grid.cells.y);
    float least = last.cost[cell];
    const auto look = [&](bool there, std::size_t at) {
      least = there ? std::min(least, last.cost[at]) : least;
    };
    look(cell % nx > 0, cell - 1);
    look(cell % nx + 1 < nx, cell + 1);
    look(cell % plane >= nx, cell - nx);
    look(cell % plane + nx < plane, cell + nx);
    look(cell >= plane, cell - plane);
    look(cell + plane < grid.size(), cell + plane);
    return least;
  }

  // Makes every cell that keeps its cost a source of the next solve, if they are worth it. How many.
  std::size_t keep() {
    if (!solved || !std::ranges::equal(last.sources, next.sources)) {
      return 0;
    }
    const float limit = least_changed_cost();
    const auto stays = [limit](float cost) { return cost < limit; };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(last.cost, stays));
    if (static_cast<double>(count) < kWorthKeeping * static_cast<double>(grid.size())) {
      return 0;
    }
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      next.cost[cell] = stays(last.cost[cell]) ? last.cost[cell] : next.cost[cell];
    }
    return count;
  }

  Grid grid;
  CostParams params;
  GoalRegion goal;
  GoalDistance goal_distance;
  std::vector<std::size_t> small;
  bool solved = false;  // whether `last` holds anything
  Solved last, next;
  EikonalSolver eikonal;
};

CostSolver::CostSolver(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
CostSolver::CostSolver(CostSolver&&) noexcept = default;
CostSolver& CostSolver::operator=(CostSolver&&) noexcept = default;
CostSolver::~CostSolver() = default;

Result<CostSolver> CostSolver::make(const Grid& grid, const PlacedShape& goal, const CostParams& params) try {
  if (auto good = check_params(params); !good) {
    return fail(std::move(good.error()));
  }
  if (auto good = check_grid(grid); !good) {
    return fail(std::move(good.error()));
  }
  auto region = GoalRegion::make(goal, grid);
  if (!region) {
    return fail(std::move(region.error()));
  }
  return CostSolver(std::make_unique<State>(grid, std::move(*region), params));
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment,
              "not enough memory for a cost field of " + std::to_string(grid.size()) + " cells");
}

CostField CostSolver::make_field() const {
  CostField field;
  field.grid = state_->grid;
  field.guide.resize(4 * state_->grid.size());
  field.kind.resize(state_->grid.size());
  return field;
}

Result<SolveStats> CostSolver::solve(const CostInput& input, int threads, CostField& field) {
  State& s = *state_;
  if (auto good = check_terms(input.terms, s.grid); !good) {
    return fail(std::move(good.error()));
  }
  if (auto good = check_offset(input.goal_offset); !good) {
    return fail(std::move(good.error()));
  }
  s.goal.move(input.goal_offset, threads, s.goal_distance);
  const float clearance = effective_clearance(s.params, s.grid);
  if (auto placed = place_sources(input.distance, s.goal_distance, clearance, s.next.sources, s.small);
      !placed) {
    return fail(std::move(placed.error()));
  }
  fill_slowness(input.distance, input.terms, s.params, s.grid, 0, s.grid.size(), s.next.slowness);
  std::ranges::copy(s.next.sources, s.next.cost.begin());
  const std::size_t kept = s.keep();
  const auto stats =
      s.eikonal.solve(s.next.slowness, s.next.cost, static_cast<unsigned>(std::max(threads, 0)));
  if (!stats) {
    return fail(stats.error());
  }
  std::swap(s.last, s.next);
  s.solved = true;
  field.grid = s.grid;
  finish_cost_field(input.distance, s.last.cost, s.params, {s.small, s.goal_distance.middle}, threads, {},
                    field);
  return SolveStats{stats->sweeps, kept > 0, s.grid.size() - kept};
}

}  // namespace mayfly::fields
