#include "fields/cost_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "fields/eikonal.hpp"
#include "fields/guide.hpp"
#include "kernels/ramp.h"

namespace mayfly::fields {
namespace {

using kernels::F;

F load_first(std::span<const float> values, std::size_t at, std::size_t count) {
  if (count == MF_LANES) {
    return kernels::mf_load(values.data() + at);
  }
  float some[MF_LANES] = {};
  std::copy_n(values.data() + at, count, some);
  return kernels::mf_load(some);
}

CellKind kind_of(bool blocked, bool reached) {
  return blocked ? CellKind::kBlocked : reached ? CellKind::kReached : CellKind::kUnreachable;
}

}  // namespace

glm::vec3 center_of(const Grid& grid, std::size_t cell) {
  const auto nx = static_cast<std::size_t>(grid.cells.x);
  const auto ny = static_cast<std::size_t>(grid.cells.y);
  return grid.center(static_cast<int>(cell % nx), static_cast<int>(cell / nx % ny),
                     static_cast<int>(cell / nx / ny));
}

float influence_of(const CostParams& params, const Grid& grid) {
  return params.influence > 0.0F ? params.influence : 2.0F * std::numbers::sqrt2_v<float> * grid.cell;
}

Result<void> check_params(const CostParams& params) {
  const auto refuse = [](const char* name, float value, const char* wanted) {
    return fail(
        Error{Cause::kCaller, std::string("cost field: bad ") + name, {}, std::to_string(value), wanted});
  };
  // Negated comparisons: NaN is refused.
  if (!(params.length_weight > 0.0F && params.length_weight <= 1e6F)) {
    return refuse("length weight", params.length_weight, "a number in (0, 1e6]");
  }
  if (!(params.repulsion_weight >= 0.0F && params.repulsion_weight <= 1e6F)) {
    return refuse("repulsion weight", params.repulsion_weight, "a number in [0, 1e6]");
  }
  if (!(params.influence >= 0.0F && params.influence <= 1e6F)) {
    return refuse("influence", params.influence, "metres in [0, 1e6]; 0 means 2√2 cells");
  }
  if (!(params.clearance >= 0.0F && params.clearance <= 1e6F)) {
    return refuse("clearance", params.clearance, "metres in [0, 1e6]");
  }
  return {};
}

Result<void> check_terms(const CostTerms& terms, const Grid& grid) {
  const std::span<const float> extra = terms.extra_slowness;
  if (!extra.empty() && extra.size() != grid.size()) {
    return fail(Error{Cause::kCaller,
                      "the extra cost of a metre has another size than the grid",
                      {},
                      std::to_string(extra.size()) + " values",
                      std::to_string(grid.size())});
  }
  bool good = true;
  for (const float value : extra) {
    good &= std::abs(value) <= kLargestExtra;
  }
  if (!good) {
    const auto bad = std::ranges::find_if(extra, [](float v) { return !(std::abs(v) <= kLargestExtra); });
    return fail(Error{Cause::kCaller,
                      "the extra cost of a metre in cell " + std::to_string(bad - extra.begin()) +
                          " is not a number, or too large",
                      {},
                      std::to_string(*bad),
                      "a number in [-1e6, 1e6]"});
  }
  return {};
}

void fill_slowness(std::span<const float> distance, const CostTerms& terms, const CostParams& params,
                   const Grid& grid, std::size_t first, std::size_t end, std::span<float> slowness) {
  const F clearance = kernels::mf_splat(effective_clearance(params, grid));
  const F blocked = kernels::mf_splat(kUnreachedCost);
  const float scale = 1.0F / influence_of(params, grid);
  const float repulsion = params.repulsion_weight / params.length_weight;
  const float per_length = 1.0F / params.length_weight;
  for (std::size_t at = first; at < end; at += MF_LANES) {
    const std::size_t count = std::min<std::size_t>(MF_LANES, end - at);
    const F phi = load_first(distance, at, count);
    F s = 1.0F + repulsion * kernels::mf_bell(phi * scale);
    if (!terms.extra_slowness.empty()) {
      s = kernels::mf_max(s + per_length * load_first(terms.extra_slowness, at, count),
                          kernels::mf_splat(kLeastSlowness));
    }
    kernels::mf_store_first(slowness.data() + at, kernels::mf_select(phi < clearance, blocked, s),
                            static_cast<int>(count));
  }
}

void set_kinds(std::span<const float> distance, std::span<const float> cost, std::size_t stride,
               float unreached, float clearance, CostField& field) {
  const std::size_t count = distance.size();
  field.kind.resize(count);
  field.blocked = 0;
  field.unreachable = 0;
  field.unreachable_example.reset();
  for (std::size_t cell = 0; cell < count; ++cell) {
    field.kind[cell] = kind_of(distance[cell] < clearance, cost[cell * stride] < unreached);
  }
  for (const CellKind kind : field.kind) {
    field.blocked += kind == CellKind::kBlocked ? 1U : 0U;
    field.unreachable += kind == CellKind::kUnreachable ? 1U : 0U;
  }
  if (field.unreachable > 0) {
    const auto first = std::ranges::find(field.kind, CellKind::kUnreachable) - field.kind.begin();
    field.unreachable_example = center_of(field.grid, static_cast<std::size_t>(first));
  }
}

void finish_cost_field(std::span<const float> distance, std::span<const float> cost, const CostParams& params,
                       const SmallGoal& small, int threads, const Progress& progress, CostField& field) {
  const float clearance = effective_clearance(params, field.grid);
  set_kinds(distance, cost, 1, kUnreachedCost, clearance, field);
  field.guide.resize(4 * cost.size());
  make_guide({field.grid, distance, cost, field.kind, clearance}, field.guide, threads, progress);
  if (small.middle) {
    point_at(*small.middle, field.grid, small.cells, field.guide);
  }
}

}  // namespace mayfly::fields
