#include "fields/make_grid.hpp"

#include <array>
#include <cmath>
#include <sstream>

namespace mayfly::fields {
namespace {

// A box whose side is a multiple of the cell in decimal is one in binary only to within rounding.
constexpr double kRounding = 1e-5;

std::array<double, 3> counts(const Box& bounds, double cell) {
  std::array<double, 3> cells{};
  for (int axis = 0; axis < 3; ++axis) {
    const double side = static_cast<double>(bounds.max[axis]) - static_cast<double>(bounds.min[axis]);
    cells[static_cast<std::size_t>(axis)] = std::fmax(1.0, std::ceil(side / cell * (1.0 - 1e-7) - kRounding));
  }
  return cells;
}

double product(const std::array<double, 3>& cells) {
  return cells[0] * cells[1] * cells[2];
}

// Two digits, rounded up: a number that a person would type.
double smallest_cell_that_fits(const Box& bounds, double cell) {
  double fits = cell;
  for (int round = 0; round < 200 && product(counts(bounds, fits)) > static_cast<double>(kMaxCells);
       ++round) {
    const double excess = product(counts(bounds, fits)) / static_cast<double>(kMaxCells);
    fits *= std::fmax(std::cbrt(excess), 1.001);
  }
  const double digit = std::pow(10.0, std::floor(std::log10(fits)) - 1.0);
  return std::ceil(fits / digit) * digit;
}

Error too_many(const Box& bounds, double cell) {
  const auto cells = counts(bounds, cell);
  std::ostringstream found;
  found << cells[0] << " × " << cells[1] << " × " << cells[2] << " cells of " << cell << " m, "
        << product(cells) * sizeof(float) / (1024.0 * 1024.0 * 1024.0) << " GiB a field";
  std::ostringstream wanted;
  wanted << "at most " << kMaxCells << " cells (1 GiB a field): a cell of "
         << smallest_cell_that_fits(bounds, cell) << " m or more, or smaller bounds";
  return Error{Cause::kCaller, "the grid is too large", std::nullopt, found.str(), wanted.str(), {}};
}

}  // namespace

Result<Grid> make_grid(const Box& bounds, float cell) {
  if (!std::isfinite(cell) || cell <= 0.0F) {
    return fail(Error{Cause::kCaller,
                      "the cell side is no length",
                      std::nullopt,
                      std::to_string(cell) + " m",
                      "a finite number above 0",
                      {}});
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(bounds.min[axis]) || !std::isfinite(bounds.max[axis]) ||
        bounds.min[axis] >= bounds.max[axis]) {
      std::ostringstream found;
      found << "min " << bounds.min[axis] << ", max " << bounds.max[axis] << " along "
            << "xyz"[axis];
      return fail(Error{Cause::kCaller,
                        "the world's box is empty or infinite",
                        std::nullopt,
                        found.str(),
                        "finite numbers, min below max",
                        {}});
    }
  }
  const auto cells = counts(bounds, static_cast<double>(cell));
  if (product(cells) > static_cast<double>(kMaxCells)) {
    return fail(too_many(bounds, static_cast<double>(cell)));
  }
  return Grid{bounds.min, cell,
              glm::ivec3(static_cast<int>(cells[0]), static_cast<int>(cells[1]), static_cast<int>(cells[2]))};
}

Result<void> check_grid(const Grid& grid) {
  if (grid.cells.x < 1 || grid.cells.y < 1 || grid.cells.z < 1 || grid.size() > kMaxCells) {
    return fail(Error{Cause::kCaller,
                      "the distance field's grid is empty or too large",
                      std::nullopt,
                      std::to_string(grid.size()) + " cells",
                      "1 to " + std::to_string(kMaxCells),
                      {}});
  }
  return {};
}

}  // namespace mayfly::fields
