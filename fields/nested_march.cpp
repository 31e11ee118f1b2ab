#include "fields/nested_march.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "kernels/ramp.h"

namespace mayfly::fields {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kFirst = 1;
constexpr int kLast = NestedGrid::kRatio;

// The smallest root of Σ max(C − cᵢ, 0)² = f² (Godunov): f is slowness · cell side.
float godunov(float a, float b, float c, float f) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  // From the least of them, so that what is squared is small.
  b -= a;
  c -= a;
  if (!(b < f)) {
    return a + f;
  }
  const float two = 0.5F * (b + std::sqrt(2.0F * f * f - b * b));
  if (!(c < two)) {
    return a + two;
  }
  const float sum = b + c;
  return a + (sum + std::sqrt(std::max(sum * sum - 3.0F * (b * b + c * c - f * f), 0.0F))) / 3.0F;
}

constexpr int kStrideY = NestedGrid::kBrickSide;
constexpr int kStrideZ = NestedGrid::kBrickSide * NestedGrid::kBrickSide;

int local_index(glm::ivec3 at) {
  return at.x + kStrideY * at.y + kStrideZ * at.z;
}

// visit(step) to the 26 neighbours.
void for_each_step(const auto& visit) {
  for (int k = -1; k <= 1; ++k) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        if (i != 0 || j != 0 || k != 0) {
          visit(glm::ivec3(i, j, k));
        }
      }
    }
  }
}

bool is_face(glm::ivec3 step) {
  return std::abs(step.x) + std::abs(step.y) + std::abs(step.z) == 1;
}

// visit(local) for the core cells of a brick that lie on its side towards −step: those that touch a
// neighbour from which `step` leads here.
void for_each_facing(glm::ivec3 step, const auto& visit) {
  glm::ivec3 low(kFirst);
  glm::ivec3 high(kLast);
  for (int axis = 0; axis < 3; ++axis) {
    if (step[axis] > 0) high[axis] = kFirst;
    if (step[axis] < 0) low[axis] = kLast;
  }
  for (int k = low.z; k <= high.z; ++k) {
    for (int j = low.y; j <= high.y; ++j) {
      for (int i = low.x; i <= high.x; ++i) {
        visit(glm::ivec3(i, j, k));
      }
    }
  }
}

// update(x, y, z) for each cell of a brick but its apron's, in one of eight orders: whether any said that it
// changed.
bool swept(int direction, const auto& update) {
  bool changed = false;
  for (int k = kFirst; k <= kLast; ++k) {
    const int z = (direction & 4) != 0 ? kLast + kFirst - k : k;
    for (int j = kFirst; j <= kLast; ++j) {
      const int y = (direction & 2) != 0 ? kLast + kFirst - j : j;
      for (int i = kFirst; i <= kLast; ++i) {
        changed |= update((direction & 1) != 0 ? kLast + kFirst - i : i, y, z);
      }
    }
  }
  return changed;
}

}  // namespace

float Slowness::at(float phi) const {
  if (phi < clearance) {
    return kInfinity;
  }
  return 1.0F + repulsion * kernels::mf_bell(kernels::mf_splat(phi * inverse_influence))[0];
}

NestedMarch::NestedMarch(NestedCosts& costs, const Slowness& slowness, const NestedSight& sight)
    : in_(costs),
      slowness_(slowness),
      sight_(sight),
      least_change_(2e-4F * costs.nested.cell()),
      waiting_(costs.nested.coarse.size(), kInfinity) {}

void NestedMarch::run(const Progress& progress) {
  wake_around_sources();
  while (!queue_.empty()) {
    const Wake next = queue_.top();
    queue_.pop();
    float& key = waiting_[static_cast<std::size_t>(next.block)];
    if (next.key != key) {
      continue;  // woken again since, with a lower key
    }
    key = kInfinity;
    const glm::ivec3 at = place(next.block);
    if (in_.nested.brick_at(at) == NestedGrid::kNoBrick) {
      relax_leaf(at);
    } else {
      relax_brick(at);
    }
    if (progress && ++relaxed_ % 16384 == 0) {
      // Nobody knows how often blocks are woken; two or three times is usual.
      const auto done = static_cast<double>(relaxed_);
      progress("cost: marching", done / (done + static_cast<double>(waiting_.size())));
    }
  }
}

void NestedMarch::wake(glm::ivec3 at, float key) {
  const std::size_t block = in_.nested.coarse.index(at.x, at.y, at.z);
  if (key < waiting_[block]) {
    waiting_[block] = key;
    queue_.push({key, static_cast<int>(block)});
  }
}

glm::ivec3 NestedMarch::place(int block) const {
  const glm::ivec3 n = in_.nested.coarse.cells;
  return {block % n.x, block / n.x % n.y, block / n.x / n.y};
}

float NestedMarch::least_fixed(glm::ivec3 at) const {
  float least = kInfinity;
  in_.nested.for_each_leaf_in(at, [&](const NestedGrid::Leaf& leaf) {
    if (in_.fixed[leaf.entry] != 0) {
      least = std::min(least, in_.cost[leaf.entry]);
    }
  });
  return least;
}

void NestedMarch::wake_around_sources() {
  for (int z = 0; z < in_.nested.coarse.cells.z; ++z) {
    in_.nested.for_each_in_plane(z, [&](glm::ivec3 at) {
      const float least = least_fixed(at);
      if (least == kInfinity) {
        return;
      }
      const auto wake_if_open = [&](glm::ivec3 to) {
        if (in_.nested.brick_at(to) != NestedGrid::kNoBrick ||
            in_.fixed[in_.nested.coarse_lattice().entry(to)] == 0) {
          wake(to, least);
        }
      };
      wake_if_open(at);
      for_each_step([&](glm::ivec3 step) {
        if (in_.nested.holds(at + step)) {
          wake_if_open(at + step);
        }
      });
    });
  }
}

void NestedMarch::relax_brick(glm::ivec3 at) {
  const auto first = static_cast<std::size_t>(in_.nested.brick_at(at));
  const std::span<float> cost = std::span(in_.cost).subspan(first, NestedGrid::kBrickEntries);
  std::array<float, NestedGrid::kBrickEntries> before{};
  std::ranges::copy(cost, before.begin());
  read_apron(at, cost);
  sweep(cost, in_.distance.subspan(first, NestedGrid::kBrickEntries),
        std::span(in_.fixed).subspan(first, NestedGrid::kBrickEntries));
  tell_neighbours(at, before, cost);
}

// The six faces of the apron, as the neighbours have it now.
void NestedMarch::read_apron(glm::ivec3 at, std::span<float> cost) const {
  const Lattice own = in_.nested.brick_lattice(at);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      glm::ivec3 step(0);
      step[axis] = side;
      for_each_facing(-step, [&](glm::ivec3 local) {
        const glm::ivec3 beyond = local + step;
        cost[static_cast<std::size_t>(local_index(beyond))] =
            in_.nested.holds(at + step)
                ? apron_cost(at + step, beyond - NestedGrid::kRatio * step, own.center(beyond))
                : kInfinity;
      });
    }
  }
}

// What `neighbour` knows of the cost at the centre p of its fine cell `local`.
float NestedMarch::apron_cost(glm::ivec3 neighbour, glm::ivec3 local, glm::vec3 p) const {
  if (in_.nested.brick_at(neighbour) != NestedGrid::kNoBrick) {
    return in_.cost[in_.nested.brick_lattice(neighbour).entry(local)];
  }
  const std::size_t c = in_.nested.coarse_lattice().entry(neighbour);
  if (in_.cost[c] == kInfinity) {
    return kInfinity;
  }
  return in_.rays[c].cost + glm::distance(in_.rays[c].from, p);
}

void NestedMarch::sweep(std::span<float> cost, std::span<const float> phi,
                        std::span<const std::uint8_t> fixed) const {
  std::array<float, NestedGrid::kBrickEntries> f{};
  NestedGrid::for_each_in_core([&](glm::ivec3 at) {
    const auto e = static_cast<std::size_t>(local_index(at));
    f[e] = fixed[e] != 0 ? kInfinity : slowness_.at(phi[e]) * in_.nested.cell();
  });
  const auto one = [&](int x, int y, int z) {
    const auto e = static_cast<std::size_t>(local_index({x, y, z}));
    if (f[e] == kInfinity) {
      return false;
    }
    const float c =
        godunov(std::min(cost[e - 1], cost[e + 1]), std::min(cost[e - kStrideY], cost[e + kStrideY]),
                std::min(cost[e - kStrideZ], cost[e + kStrideZ]), f[e]);
    if (c < cost[e] - least_change_) {
      cost[e] = c;
      return true;
    }
    return false;
  };
  // Eight directions in turn, until each has changed nothing once.
  int quiet = 0;
  for (int direction = 0; quiet < 8; direction = (direction + 1) % 8) {
    quiet = swept(direction, one) ? 1 : quiet + 1;
  }
}

// Wakes whom a lower cost on this brick's sides may concern.
void NestedMarch::tell_neighbours(glm::ivec3 at, std::span<const float> before,
                                  std::span<const float> after) {
  const Lattice own = in_.nested.brick_lattice(at);
  for_each_step([&](glm::ivec3 step) {
    const glm::ivec3 to = at + step;
    const bool face = is_face(step);
    if (!in_.nested.holds(to)) {
      return;
    }
    const bool brick = in_.nested.brick_at(to) != NestedGrid::kNoBrick;
    if (brick && !face) {
      return;
    }
    const glm::vec3 center = in_.nested.coarse.center(to.x, to.y, to.z);
    const Lattice there = brick ? in_.nested.brick_lattice(to) : in_.nested.coarse_lattice();
    const float known = brick ? kInfinity : in_.cost[there.entry(to)] + in_.nested.cell();
    float least = kInfinity;
    for_each_facing(-step, [&](glm::ivec3 local) {
      const auto e = static_cast<std::size_t>(local_index(local));
      if (!(after[e] < before[e])) {
        return;
      }
      const bool better = brick ? after[e] < in_.cost[there.entry(local + step - NestedGrid::kRatio * step)]
                                : after[e] + glm::distance(own.center(local), center) < known;
      if (better) {
        least = std::min(least, after[e]);
      }
    });
    if (least < kInfinity) {
      wake(to, least);
    }
  });
}

void NestedMarch::relax_leaf(glm::ivec3 at) {
  const std::size_t c = in_.nested.coarse_lattice().entry(at);
  if (in_.fixed[c] != 0 || slowness_.at(in_.distance[c]) == kInfinity) {
    return;
  }
  Best best{in_.nested.coarse.center(at.x, at.y, at.z), in_.cost[c], in_.rays[c]};
  for_each_step([&](glm::ivec3 step) {
    const glm::ivec3 from = at + step;
    if (!in_.nested.holds(from)) {
      return;
    }
    if (in_.nested.brick_at(from) == NestedGrid::kNoBrick) {
      through_leaf(from, is_face(step), best);
    } else {
      through_brick(from, step, best);
    }
  });
  if (!(best.cost < in_.cost[c] - least_change_)) {
    return;
  }
  in_.cost[c] = best.cost;
  in_.rays[c] = best.ray;
  for_each_step([&](glm::ivec3 step) {
    if (in_.nested.holds(at + step)) {
      tell_from_leaf(at, step);
    }
  });
}

// Wakes the neighbour, if what this coarse cell knows may concern it.
void NestedMarch::tell_from_leaf(glm::ivec3 at, glm::ivec3 step) {
  const std::size_t c = in_.nested.coarse_lattice().entry(at);
  const Ray ray = in_.rays[c];
  const glm::ivec3 to = at + step;
  const bool face = is_face(step);
  if (in_.nested.brick_at(to) == NestedGrid::kNoBrick) {
    const std::size_t other = in_.nested.coarse_lattice().entry(to);
    const float cost = ray.cost + glm::distance(ray.from, in_.nested.coarse.center(to.x, to.y, to.z));
    if (in_.fixed[other] == 0 && cost < in_.cost[other] - least_change_) {
      wake(to, cost);
    }
    return;
  }
  if (!face) {
    return;
  }
  const Lattice there = in_.nested.brick_lattice(to);
  float least = kInfinity;
  for_each_facing(step, [&](glm::ivec3 local) {
    const float cost = ray.cost + glm::distance(ray.from, there.center(local - step));
    if (cost < in_.cost[there.entry(local)] - least_change_) {
      least = std::min(least, cost);
    }
  });
  if (least < kInfinity) {
    wake(to, least);
  }
}

// Takes a ray that is known to be clear of obstacles, if it is the cheapest so far.
void NestedMarch::offer(const Ray& ray, Best& best) const {
  const float cost = ray.cost + glm::distance(ray.from, best.center);
  if (cost < best.cost - least_change_) {
    best.cost = cost;
    best.ray = ray;
  }
}

// On the straight line to where the neighbour's path last bent; or by way of the neighbour, which shares a
// face with this cell.
void NestedMarch::through_leaf(glm::ivec3 neighbour, bool face, Best& best) const {
  const std::size_t c = in_.nested.coarse_lattice().entry(neighbour);
  if (in_.cost[c] == kInfinity) {
    return;
  }
  const Ray ray = in_.rays[c];
  if (ray.cost + glm::distance(ray.from, best.center) < best.cost - least_change_ &&
      sight_.clear(best.center, ray.from)) {
    offer(ray, best);
  }
  if (face) {
    offer({in_.nested.coarse.center(neighbour.x, neighbour.y, neighbour.z), in_.cost[c]}, best);
  }
}

// By way of the fine cell of the brick's side that makes it cheapest.
void NestedMarch::through_brick(glm::ivec3 neighbour, glm::ivec3 step, Best& best) const {
  const Lattice there = in_.nested.brick_lattice(neighbour);
  glm::ivec3 through(0);
  float least = best.cost - least_change_;
  for_each_facing(step, [&](glm::ivec3 local) {
    const float cost = in_.cost[there.entry(local)] + glm::distance(there.center(local), best.center);
    if (cost < least) {
      least = cost;
      through = local;
    }
  });
  if (through != glm::ivec3(0)) {
    offer({there.center(through), in_.cost[there.entry(through)]}, best);
    straighten(neighbour, through, best);
  }
}

// Follows the path on through the brick, as far as it can be seen from here: the farther the point to which
// a straight line goes, the less the direction depends on the grid.
void NestedMarch::straighten(glm::ivec3 neighbour, glm::ivec3 local, Best& best) const {
  const Lattice there = in_.nested.brick_lattice(neighbour);
  for (int steps = 0; steps < 3 * NestedGrid::kRatio; ++steps) {
    glm::ivec3 next = local;
    float steepest = 0.0F;
    for_each_step([&](glm::ivec3 step) {
      const float drop = in_.cost[there.entry(local)] - in_.cost[there.entry(local + step)];
      const float slope = drop / glm::length(glm::vec3(step));
      if (slope > steepest) {
        steepest = slope;
        next = local + step;
      }
    });
    if (next == local || !sight_.clear(best.center, there.center(next))) {
      return;
    }
    offer({there.center(next), in_.cost[there.entry(next)]}, best);
    local = next;
    const glm::ivec3 out = (local + NestedGrid::kRatio - 1) / NestedGrid::kRatio - 1;
    if (out != glm::ivec3(0)) {
      const glm::ivec3 at = neighbour + out;
      if (in_.nested.holds(at) && in_.nested.brick_at(at) == NestedGrid::kNoBrick) {
        through_leaf(at, false, best);
      }
      return;
    }
  }
}

}  // namespace mayfly::fields
