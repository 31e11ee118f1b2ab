#include "fields/nested_distance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <new>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include "fields/brick_sampler.hpp"
#include "fields/distance_field.hpp"
#include "fields/make_grid.hpp"
#include "fields/parallel.hpp"
#include "fields/spline.hpp"

namespace mayfly::fields {
namespace {

// A side that is a whole number of cells in decimal is one in binary only to within rounding.
constexpr double kRounding = 1e-4;

Result<void> check_sides(const Box& bounds, float cell) {
  const double side = static_cast<double>(cell) * NestedGrid::kRatio;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = static_cast<double>(bounds.max[axis]) - static_cast<double>(bounds.min[axis]);
    const double count = std::max(1.0, std::round(length / side));
    if (std::fabs(length / side - count) > kRounding) {
      std::ostringstream found;
      found << length << " m along "
            << "xyz"[axis];
      std::ostringstream wanted;
      wanted << "a whole multiple of a coarse cell of " << side << " m: " << count * side << " m";
      return fail(Error{Cause::kCaller,
                        "a nested world's bounds do not fit its cells",
                        std::nullopt,
                        found.str(),
                        wanted.str(),
                        {}});
    }
  }
  return {};
}

// What the coarse samples alone leave open: cells whose points may come within reach.
class Candidates {
 public:
  Candidates(const BrickReach& reach, float half_diagonal) : reach_(reach), half_diagonal_(half_diagonal) {}

  bool by_obstacles(float phi) const {
    return phi < reach_.outside + half_diagonal_ && phi > -reach_.inside - half_diagonal_;
  }
  bool by_goal(float phi) const { return std::fabs(phi) < reach_.goal + half_diagonal_; }
  // What the exact samples leave: they lie no farther than half a fine cell's diagonal from any point.
  bool confirmed(std::span<const float> phi, float half_cell_diagonal) const {
    const auto [low, high] = std::ranges::minmax(phi);
    return low < reach_.outside + half_cell_diagonal && high > -reach_.inside - half_cell_diagonal;
  }

 private:
  BrickReach reach_;
  float half_diagonal_;
};

struct Maker {
  const Geometry& obstacles;
  std::span<const Geometry> goals;
  const BrickReach& reach;
  int threads;
  const Progress& progress;

  Result<NestedDistance> make(const Grid& coarse) const {
    auto at_coarse = build_distance_field(obstacles, coarse, threads, progress);
    if (!at_coarse) {
      return fail(std::move(at_coarse.error()));
    }
    NestedDistance field{{coarse, std::vector<int>(coarse.size(), NestedGrid::kNoBrick), 0},
                         std::move(at_coarse->distance)};
    std::vector<std::uint8_t> at_goal(coarse.size(), 0);
    const float half_diagonal = 0.5F * std::numbers::sqrt3_v<float> * coarse.cell;
    const Candidates wanted(reach, half_diagonal);
    for (const Geometry& goal : goals) {
      auto sampled = build_distance_field(goal, coarse, threads, progress);
      if (!sampled) {
        return fail(std::move(sampled.error()));
      }
      for (std::size_t c = 0; c < at_goal.size(); ++c) {
        if (wanted.by_goal(sampled->distance[c])) {
          at_goal[c] = 1;
        }
      }
    }
    if (auto filled = add_bricks(wanted, at_goal, field); !filled) {
      return fail(std::move(filled.error()));
    }
    return field;
  }

  // Plane by plane of coarse cells, the rows of a plane at once.
  Result<void> add_bricks(const Candidates& wanted, std::span<const std::uint8_t> at_goal,
                          NestedDistance& field) const {
    const Grid fine = field.nested.fine();
    const BrickSampler sampler(obstacles, fine);
    const float half_cell = 0.5F * std::numbers::sqrt3_v<float> * fine.cell;
    const glm::ivec3 n = field.nested.coarse.cells;
    std::vector<std::vector<int>> xs(static_cast<std::size_t>(n.y));
    std::vector<std::vector<float>> values(xs.size());
    for (int z = 0; z < n.z; ++z) {
      parallel_for(xs.size(), threads, "distance: bricks", {}, [&](std::size_t y) {
        const std::size_t row = field.nested.coarse.index(0, static_cast<int>(y), z);
        xs[y].clear();
        for (int x = 0; x < n.x; ++x) {
          const std::size_t c = row + static_cast<std::size_t>(x);
          if (at_goal[c] != 0 || (!obstacles.empty() && wanted.by_obstacles(field.distance[c]))) {
            xs[y].push_back(x);
          }
        }
        values[y].resize(xs[y].size() * NestedGrid::kBrickEntries);
        sampler.fill_row(xs[y], static_cast<int>(y), z, values[y]);
      });
      for (std::size_t y = 0; y < xs.size(); ++y) {
        const std::size_t row = field.nested.coarse.index(0, static_cast<int>(y), z);
        for (std::size_t b = 0; b < xs[y].size(); ++b) {
          const std::span<const float> phi =
              std::span(values[y]).subspan(b * NestedGrid::kBrickEntries, NestedGrid::kBrickEntries);
          const std::size_t c = row + static_cast<std::size_t>(xs[y][b]);
          if (at_goal[c] != 0 || wanted.confirmed(phi, half_cell)) {
            field.nested.brick[c] = static_cast<int>(field.distance.size());
            field.distance.insert(field.distance.end(), phi.begin(), phi.end());
            ++field.nested.bricks;
          }
        }
      }
      if (field.distance.size() > kMaxCells) {
        return fail(Error{Cause::kCaller,
                          "the nested grid is too large",
                          std::nullopt,
                          "more than " + std::to_string(kMaxCells) + " cells, coarse and fine",
                          "a larger cell, smaller bounds or fewer obstacles",
                          {}});
      }
      if (progress) {
        progress("distance: bricks", static_cast<double>(z + 1) / n.z);
      }
    }
    field.distance.shrink_to_fit();
    return {};
  }
};

// φ on the fine grid around a brick, m; from the coarse cells where there is no brick, which is rough, but
// far from everything.
float phi_around(const NestedDistance& field, glm::ivec3 fine) {
  const NestedGrid& nested = field.nested;
  fine = glm::clamp(fine, glm::ivec3(0), nested.coarse.cells * NestedGrid::kRatio - 1);
  const glm::ivec3 at = fine / NestedGrid::kRatio;
  if (nested.brick_at(at) == NestedGrid::kNoBrick) {
    return field.distance[nested.coarse_lattice().entry(at)];
  }
  return field.distance[nested.brick_lattice(at).entry(fine - NestedGrid::kRatio * at + 1)];
}

// The filter that makes coefficients forgets by a factor of six a cell.
constexpr int kFilterReach = 4;

void fill_coefficients(const NestedDistance& field, glm::ivec3 at, std::span<float> walls) {
  constexpr int kSide = NestedGrid::kBrickSide + 2 * kFilterReach;
  const Grid window{glm::vec3(0.0F), field.nested.cell(), glm::ivec3(kSide)};
  const Lattice own = field.nested.brick_lattice(at);
  const glm::ivec3 first = NestedGrid::kRatio * at - 1 - kFilterReach;
  std::vector<float> phi(window.size());
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        phi[window.index(i, j, k)] = phi_around(field, first + glm::ivec3(i, j, k));
      }
    }
  }
  // The apron is exact beyond the world, and beside a coarse cell.
  for (int k = 0; k < NestedGrid::kBrickSide; ++k) {
    for (int j = 0; j < NestedGrid::kBrickSide; ++j) {
      for (int i = 0; i < NestedGrid::kBrickSide; ++i) {
        phi[window.index(i + kFilterReach, j + kFilterReach, k + kFilterReach)] =
            field.distance[own.entry({i, j, k})];
      }
    }
  }
  const std::vector<float> coefficients = spline_coefficients(window, phi);
  for (int k = 0; k < NestedGrid::kBrickSide; ++k) {
    for (int j = 0; j < NestedGrid::kBrickSide; ++j) {
      for (int i = 0; i < NestedGrid::kBrickSide; ++i) {
        walls[own.entry({i, j, k})] =
            coefficients[window.index(i + kFilterReach, j + kFilterReach, k + kFilterReach)];
      }
    }
  }
}

}  // namespace

Result<NestedDistance> build_nested_distance(const Geometry& obstacles, std::span<const Geometry> goals,
                                             const Box& bounds, float cell, const BrickReach& reach,
                                             int threads, const Progress& progress) try {
  auto coarse = make_grid(bounds, cell * static_cast<float>(NestedGrid::kRatio));
  if (!coarse) {
    return fail(std::move(coarse.error()));
  }
  if (auto fits = check_sides(bounds, cell); !fits) {
    return fail(std::move(fits.error()));
  }
  return Maker{obstacles, goals, reach, threads, progress}.make(*coarse);
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for the nested distance field");
}

Result<std::vector<float>> sample_nested(const Geometry& geometry, const NestedGrid& nested, int threads,
                                         const Progress& progress) try {
  auto coarse = build_distance_field(geometry, nested.coarse, threads, progress);
  if (!coarse || geometry.empty()) {
    return coarse ? Result<std::vector<float>>(std::vector<float>(nested.entries(), kNoObstacle))
                  : fail(std::move(coarse.error()));
  }
  std::vector<float> values = std::move(coarse->distance);
  values.resize(nested.entries());
  const Grid fine = nested.fine();
  const BrickSampler sampler(geometry, fine);
  const auto across = static_cast<std::size_t>(nested.coarse.cells.y);
  const std::size_t rows = across * static_cast<std::size_t>(nested.coarse.cells.z);
  parallel_for(rows, threads, "distance: goal", progress, [&](std::size_t row) {
    const glm::ivec3 start(0, static_cast<int>(row % across), static_cast<int>(row / across));
    std::vector<int> xs;
    for (glm::ivec3 at = start; at.x < nested.coarse.cells.x; ++at.x) {
      if (nested.brick_at(at) != NestedGrid::kNoBrick) {
        xs.push_back(at.x);
      }
    }
    std::vector<float> bricks(xs.size() * NestedGrid::kBrickEntries);
    sampler.fill_row(xs, start.y, start.z, bricks);
    for (std::size_t b = 0; b < xs.size(); ++b) {
      const auto from = bricks.begin() + static_cast<std::ptrdiff_t>(b * NestedGrid::kBrickEntries);
      std::copy_n(from, NestedGrid::kBrickEntries,
                  values.begin() + nested.brick_at({xs[b], start.y, start.z}));
    }
  });
  return values;
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for a distance on the nested grid");
}

std::vector<float> nested_walls(const NestedDistance& field, int threads, const Progress& progress) {
  std::vector<float> walls(field.nested.entries());
  for (std::size_t c = 0; c < field.nested.coarse.size(); ++c) {
    walls[c] = std::bit_cast<float>(std::max(field.nested.brick[c], 0));
  }
  parallel_for(static_cast<std::size_t>(field.nested.coarse.cells.z), threads, "distance: walls", progress,
               [&](std::size_t z) {
                 field.nested.for_each_in_plane(static_cast<int>(z), [&](glm::ivec3 at) {
                   if (field.nested.brick_at(at) != NestedGrid::kNoBrick) {
                     fill_coefficients(field, at, walls);
                   }
                 });
               });
  return walls;
}

}  // namespace mayfly::fields
