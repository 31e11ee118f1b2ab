#include "fields/nested_guide.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <vector>

#include "fields/eikonal.hpp"
#include "fields/guide.hpp"
#include "fields/parallel.hpp"

namespace mayfly::fields {
namespace {

constexpr int kRatio = NestedGrid::kRatio;
constexpr int kNoBrick = NestedGrid::kNoBrick;
// Cells from a brick's side over which its directions give way to the coarse ones.
constexpr float kBlend = 2.0F;
// Cells from a goal's surface, or beyond what walls turn, within which they do not.
constexpr float kOwn = 2.0F;

class NestedGuide {
 public:
  NestedGuide(const NestedGuideInput& input, CostField& field)
      : in_(input), nested_(input.costs.nested), field_(field) {}

  void coarse_leaf(glm::ivec3 at) {
    const std::size_t c = nested_.coarse_lattice().entry(at);
    if (in_.costs.fixed[c] != 0) {
      field_.guide[4 * c + 3] = in_.costs.cost[c];
      return;
    }
    if (field_.kind[c] != CellKind::kReached) {
      // Who is beside an obstacle must not take its inside for a place without a way.
      set(c, glm::vec3(0.0F), field_.kind[c] == CellKind::kBlocked ? 0.0F : kUnreachableGuide);
      return;
    }
    const glm::vec3 way = in_.costs.rays[c].from - nested_.coarse.center(at.x, at.y, at.z);
    const float length = glm::length(way);
    set(c, length > 0.0F ? way / length : glm::vec3(0.0F), in_.costs.cost[c]);
  }

  // make_guide on the brick and two cells around it: blocked cells look at their neighbours, and these at
  // theirs.
  void core(glm::ivec3 at) {
    constexpr int kSide = kRatio + 4;
    const Grid window{nested_.corner(at) - 2.0F * nested_.cell(), nested_.cell(), glm::ivec3(kSide)};
    std::vector<float> distance(window.size());
    std::vector<float> cost(window.size());
    std::vector<CellKind> kind(window.size());
    const Neighbourhood around = look_around(at);
    for (int k = 0; k < kSide; ++k) {
      for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
          const std::size_t w = window.index(i, j, k);
          const Known here = known(at, glm::ivec3(i, j, k) - 1, around);
          distance[w] = here.distance;
          cost[w] = here.cost;
          kind[w] = here.kind;
        }
      }
    }
    std::vector<float> guide(4 * window.size());
    make_guide({window, distance, cost, kind, in_.clearance}, guide, 1, {});
    const Lattice own = nested_.brick_lattice(at);
    NestedGrid::for_each_in_core([&](glm::ivec3 local) {
      const std::size_t e = own.entry(local);
      const float* from = &guide[4 * window.index(local.x + 1, local.y + 1, local.z + 1)];
      const bool exact = in_.costs.fixed[e] != 0 && !near_wall(e);
      if (!exact) {
        set(e, {from[0], from[1], from[2]}, from[3]);
      }
      field_.guide[4 * e + 3] = from[3];
    });
  }

  // What coarse cells interpolate with where there is a brick: the mean of its middle cells that are reached,
  // or of all that are.
  void cover(glm::ivec3 at) {
    const Lattice own = nested_.brick_lattice(at);
    glm::vec4 sum(0.0F);
    for (const int rim : {kRatio / 2 - 1, 0}) {
      float count = 0.0F;
      NestedGrid::for_each_in_core([&](glm::ivec3 local) {
        const std::size_t e = own.entry(local);
        const bool within = glm::all(glm::greaterThan(local, glm::ivec3(rim))) &&
                            glm::all(glm::lessThan(local, glm::ivec3(kRatio + 1 - rim)));
        if (within && field_.kind[e] == CellKind::kReached) {
          sum += entry(e);
          count += 1.0F;
        }
      });
      if (count > 0.0F) {
        sum /= count;
        break;
      }
    }
    const std::size_t c = nested_.coarse_lattice().entry(at);
    const bool reached = sum != glm::vec4(0.0F);
    field_.kind[c] = reached ? CellKind::kReached : CellKind::kBlocked;
    set(c, glm::vec3(sum), sum.w);
  }

  void blend(glm::ivec3 at) {
    const Lattice own = nested_.brick_lattice(at);
    const Neighbourhood around = look_around(at);
    NestedGrid::for_each_in_core([&](glm::ivec3 local) {
      const std::size_t e = own.entry(local);
      if (field_.kind[e] != CellKind::kReached || near_wall(e) || in_.costs.cost[e] < kOwn * nested_.cell()) {
        return;
      }
      const float share = 1.0F - way_to_coarse(local, around) / kBlend;
      if (share > 0.0F) {
        const glm::vec3 coarse = glm::vec3(interpolated(own.center(local)));
        const glm::vec3 mixed = glm::mix(glm::vec3(entry(e)), unit(coarse), share);
        set(e, unit(mixed), field_.guide[4 * e + 3]);
      }
    });
  }

  void apron(glm::ivec3 at) {
    const Lattice own = nested_.brick_lattice(at);
    const auto one = [&](glm::ivec3 local) {
      const std::size_t e = own.entry(local);
      const glm::ivec3 fine =
          glm::clamp(kRatio * at + local - 1, glm::ivec3(0), nested_.coarse.cells * kRatio - 1);
      const glm::ivec3 there = fine / kRatio;
      if (nested_.brick_at(there) == kNoBrick) {
        const std::size_t c = nested_.coarse_lattice().entry(there);
        const glm::vec4 value = interpolated(own.center(local));
        field_.kind[e] = field_.kind[c];
        set(e, unit(glm::vec3(value)), value.w);
        return;
      }
      const std::size_t from = nested_.brick_lattice(there).entry(fine - kRatio * there + 1);
      field_.kind[e] = field_.kind[from];
      set(e, glm::vec3(entry(from)), field_.guide[4 * from + 3]);
    };
    for (int k = 0; k <= kRatio + 1; ++k) {
      for (int j = 0; j <= kRatio + 1; ++j) {
        const bool side = k == 0 || j == 0 || k == kRatio + 1 || j == kRatio + 1;
        for (int i = 0; i <= kRatio + 1; i += side ? 1 : kRatio + 1) {
          one({i, j, k});
        }
      }
    }
  }

 private:
  struct Known {
    float distance, cost;
    CellKind kind;
  };
  // One a neighbour, and itself: the brick's entry, kNoBrick, or kOutside.
  static constexpr int kOutside = -2;
  using Neighbourhood = std::array<int, 27>;

  static std::size_t slot(glm::ivec3 step) {
    const int index = step.x + 1 + 3 * (step.y + 1) + 9 * (step.z + 1);
    return static_cast<std::size_t>(index);
  }
  static glm::vec3 unit(glm::vec3 a) {
    const float length = glm::length(a);
    return length > 1e-6F ? a / length : glm::vec3(0.0F);
  }

  Neighbourhood look_around(glm::ivec3 at) const {
    Neighbourhood around{};
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const glm::ivec3 to = at + glm::ivec3(i, j, k);
          around[slot({i, j, k})] = nested_.holds(to) ? nested_.brick_at(to) : kOutside;
        }
      }
    }
    return around;
  }

  glm::vec4 entry(std::size_t e) const {
    const float* g = &field_.guide[4 * e];
    return {g[0], g[1], g[2], g[3]};
  }
  void set(std::size_t e, glm::vec3 direction, float cost) {
    field_.guide[4 * e + 0] = direction.x;
    field_.guide[4 * e + 1] = direction.y;
    field_.guide[4 * e + 2] = direction.z;
    field_.guide[4 * e + 3] = cost;
  }
  bool near_wall(std::size_t e) const {
    return in_.costs.distance[e] - in_.clearance < kOwn * nested_.cell();
  }

  // Of fine cell `local` of the brick at `at`, which may lie two cells outside of it.
  Known known(glm::ivec3 at, glm::ivec3 local, const Neighbourhood& around) const {
    const glm::ivec3 step = (local + 2 * kRatio - 1) / kRatio - 2;
    const int brick = around[slot(step)];
    const glm::ivec3 there = local - kRatio * step;
    if (brick >= 0) {
      const std::size_t e =
          static_cast<std::size_t>(brick) +
          static_cast<std::size_t>(there.x +
                                   NestedGrid::kBrickSide * (there.y + NestedGrid::kBrickSide * there.z));
      return {in_.costs.distance[e], in_.costs.cost[e], field_.kind[e]};
    }
    if (brick == kOutside) {
      const Lattice own = nested_.brick_lattice(at);
      const glm::ivec3 nearest = glm::clamp(local, glm::ivec3(0), glm::ivec3(kRatio + 1));
      const float phi = in_.costs.distance[own.entry(nearest)];
      return {phi, kUnreachedCost, phi < in_.clearance ? CellKind::kBlocked : CellKind::kUnreachable};
    }
    const std::size_t c = nested_.coarse_lattice().entry(at + step);
    const glm::vec3 p = nested_.corner(at) + nested_.cell() * (glm::vec3(local) - 0.5F);
    const float cost = field_.kind[c] == CellKind::kReached
                           ? in_.costs.rays[c].cost + glm::distance(in_.costs.rays[c].from, p)
                           : kUnreachedCost;
    return {in_.costs.distance[c], cost, field_.kind[c]};
  }

  // Fine cells from a core cell's centre to the nearest side beside a coarse cell.
  static float way_to_coarse(glm::ivec3 local, const Neighbourhood& around) {
    float least = kBlend;
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const glm::ivec3 step(i, j, k);
          if (around[slot(step)] != kNoBrick) {
            continue;
          }
          glm::vec3 way(0.0F);
          for (int axis = 0; axis < 3; ++axis) {
            const int cells = step[axis] < 0 ? local[axis] : kRatio + 1 - local[axis];
            way[axis] = step[axis] == 0 ? 0.0F : static_cast<float>(cells) - 0.5F;
          }
          least = std::min(least, std::max({way.x, way.y, way.z}));
        }
      }
    }
    return least;
  }

  // The coarse cells' guide at p, as an engine interpolates it.
  glm::vec4 interpolated(glm::vec3 p) const {
    const glm::vec3 last(nested_.coarse.cells - 1);
    const glm::vec3 u =
        glm::clamp((p - nested_.coarse.origin) / nested_.coarse.cell - 0.5F, glm::vec3(0.0F), last);
    const glm::ivec3 low(u);
    const glm::ivec3 high = glm::min(low + 1, nested_.coarse.cells - 1);
    const glm::vec3 t = u - glm::vec3(low);
    glm::vec4 sum(0.0F);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::bvec3 up((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
      const glm::vec3 w = glm::mix(1.0F - t, t, up);
      const glm::ivec3 at = glm::mix(low, high, up);
      sum += w.x * w.y * w.z * entry(nested_.coarse_lattice().entry(at));
    }
    return sum;
  }

  const NestedGuideInput& in_;
  const NestedGrid& nested_;
  CostField& field_;
};

}  // namespace

void fill_nested_guide(const NestedGuideInput& input, int threads, const Progress& progress,
                       CostField& field) {
  NestedGuide guide(input, field);
  const NestedGrid& nested = input.costs.nested;
  const auto planes = static_cast<std::size_t>(nested.coarse.cells.z);
  const auto for_each = [&](std::string_view stage, bool bricks, const auto& work) {
    parallel_for(planes, threads, stage, progress, [&](std::size_t z) {
      nested.for_each_in_plane(static_cast<int>(z), [&](glm::ivec3 at) {
        if ((nested.brick_at(at) != kNoBrick) == bricks) {
          work(at);
        }
      });
    });
  };
  for_each("cost: directions", false, [&](glm::ivec3 at) { guide.coarse_leaf(at); });
  for_each("cost: walls", true, [&](glm::ivec3 at) { guide.core(at); });
  for_each("cost: walls", true, [&](glm::ivec3 at) { guide.cover(at); });
  for_each("cost: seams", true, [&](glm::ivec3 at) { guide.blend(at); });
  for_each("cost: seams", true, [&](glm::ivec3 at) { guide.apron(at); });
}

}  // namespace mayfly::fields
