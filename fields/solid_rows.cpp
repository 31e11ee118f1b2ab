#include "fields/solid_rows.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fields/scan_lines.hpp"

namespace mayfly::fields {
namespace {

struct Range {
  int first = 0;
  int last = -1;
};

// The cells along an axis whose centres may lie within [low, high]: a little more, as centres are rounded;
// the crossing test decides.
Range cells_between(float low, float high, const SampleBox& samples, int axis) {
  constexpr double kSlack = 0.05;
  const double cell = static_cast<double>(samples.grid.cell);
  const double origin = samples.center(0, 0, 0)[axis] - 0.5 * cell;
  const double first = std::ceil((static_cast<double>(low) - origin) / cell - 0.5 - kSlack);
  const double last = std::floor((static_cast<double>(high) - origin) / cell - 0.5 + kSlack);
  const double end = static_cast<double>(samples.cells()[axis]) - 1.0;
  if (first > end || last < 0.0) {
    return {};
  }
  return {static_cast<int>(std::max(first, 0.0)), static_cast<int>(std::min(last, end))};
}

}  // namespace

// visit(row, center, passes) for each row that crosses the triangle.
void SolidRows::cross_triangle(const TriangleTree::Corners& t, const auto& visit) const {
  const auto [low_y, high_y] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto [low_z, high_z] = std::minmax({t[0].z, t[1].z, t[2].z});
  const Range js = cells_between(low_y, high_y, samples_, 1);
  const Range ks = cells_between(low_z, high_z, samples_, 2);
  for (int k = ks.first; k <= ks.last; ++k) {
    for (int j = js.first; j <= js.last; ++j) {
      const glm::dvec3 center = samples_.center(0, j, k);
      if (const int passes = crossing(t[0], t[1], t[2], center.y, center.z); passes != 0) {
        visit(row_index(j, k), center, passes);
      }
    }
  }
}

// visit(row, solid, corners, center, passes) for each crossing.
void SolidRows::cross(std::span<const TriangleTree> solids, const auto& visit) const {
  for (std::uint32_t solid = 0; solid < solids.size(); ++solid) {
    for (const TriangleTree::Corners& t : solids[solid].triangles()) {
      cross_triangle(t, [&](std::size_t row, const glm::dvec3& center, int passes) {
        visit(row, solid, t, center, passes);
      });
    }
  }
}

SolidRows::SolidRows(std::span<const TriangleTree> solids, const SampleBox& samples)
    : samples_(samples), cells_(samples.cells()) {
  const std::size_t rows = row_index(0, cells_.z);
  first_.assign(rows + 1, 0);
  cross(solids, [&](std::size_t row, auto, const auto&, const auto&, int) { ++first_[row + 1]; });
  for (std::size_t row = 0; row < rows; ++row) {
    first_[row + 1] += first_[row];
  }
  crossings_.resize(first_[rows]);
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  cross(solids, [&](std::size_t row, std::uint32_t solid, const TriangleTree::Corners& t,
                    const glm::dvec3& at, int passes) {
    crossings_[next[row]++] = {crossing_x(t[0], t[1], t[2], at.y, at.z), passes, solid};
  });
  for (std::size_t row = 0; row < rows; ++row) {
    std::sort(
        crossings_.begin() + static_cast<std::ptrdiff_t>(first_[row]),
        crossings_.begin() + static_cast<std::ptrdiff_t>(first_[row + 1]),
        [](const Crossing& a, const Crossing& b) { return std::tie(a.solid, a.x) < std::tie(b.solid, b.x); });
  }
}

std::vector<int> SolidRows::owners(int j, int k) const {
  std::vector<int> row(static_cast<std::size_t>(cells_.x), kNobody);
  const std::size_t end = first_[row_index(j, k) + 1];
  int winding = 0;
  for (std::size_t c = first_[row_index(j, k)]; c + 1 < end; ++c) {
    winding += crossings_[c].passes;
    // A closed surface is left as often as it is entered, so the winding number is 0 where the next solid
    // begins.
    if (winding != 0) {
      claim(row, crossings_[c].x, crossings_[c + 1].x, static_cast<int>(crossings_[c].solid));
    }
  }
  return row;
}

// Cells whose centre lies in (from, to].
void SolidRows::claim(std::vector<int>& row, double from, double to, int solid) const {
  const auto center_x = [&](int i) { return samples_.center(i, 0, 0).x; };
  const double cell = static_cast<double>(samples_.grid.cell);
  const double start = (from - center_x(0)) / cell - 1.0;
  int i = static_cast<int>(std::clamp(start, 0.0, static_cast<double>(cells_.x)));
  for (; i < cells_.x && center_x(i) <= to; ++i) {
    if (center_x(i) > from) {
      int& owner = row[static_cast<std::size_t>(i)];
      owner = owner == kNobody || owner == solid ? solid : kSeveral;
    }
  }
}

}  // namespace mayfly::fields
