#include "fields/guide.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "fields/eikonal.hpp"
#include "fields/parallel.hpp"

namespace mayfly::fields {
namespace {

// A wall turns directions along itself in the cells between the clearance and this much more, in cells.
constexpr float kTurnReach = 1.5F;
// How much a blocked cell beside free ones leads away from the wall, against its neighbours' direction of
// length 1.
constexpr float kPush = 0.25F;

float smooth(float r) {
  const float t = std::clamp(r, 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

class GuideMaker {
 public:
  GuideMaker(const GuideInput& input, std::span<float> guide) : in_(input), guide_(guide) {
    for (std::size_t cell = 0; cell < in_.cost.size(); ++cell) {
      if (in_.kind[cell] == CellKind::kReached) {
        farthest_ = std::max(farthest_, in_.cost[cell]);
      }
    }
  }

  // Reached and unreachable cells first, because blocked ones look at them.
  void free_plane(int z) {
    for_plane(z, [&](glm::ivec3 at, std::size_t cell) {
      if (in_.kind[cell] == CellKind::kReached) {
        set(cell, turned(at, cell, descent(at, cell)), in_.cost[cell]);
      } else if (in_.kind[cell] == CellKind::kUnreachable) {
        set(cell, glm::vec3(0.0F), kUnreachableGuide);
      }
    });
  }

  void blocked_plane(int z) {
    for_plane(z, [&](glm::ivec3 at, std::size_t cell) {
      if (in_.kind[cell] == CellKind::kBlocked) {
        fill_blocked(at, cell);
      }
    });
  }

 private:
  template <class Function>
  void for_plane(int z, Function function) {
    for (int y = 0; y < in_.grid.cells.y; ++y) {
      for (int x = 0; x < in_.grid.cells.x; ++x) {
        function(glm::ivec3(x, y, z), in_.grid.index(x, y, z));
      }
    }
  }

  bool inside(glm::ivec3 at) const {
    const glm::ivec3 n = in_.grid.cells;
    return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < n.x && at.y < n.y && at.z < n.z;
  }
  std::size_t index(glm::ivec3 at) const { return in_.grid.index(at.x, at.y, at.z); }

  void set(std::size_t cell, glm::vec3 direction, float cost) {
    guide_[4 * cell + 0] = direction.x;
    guide_[4 * cell + 1] = direction.y;
    guide_[4 * cell + 2] = direction.z;
    guide_[4 * cell + 3] = cost;
  }

  // −∇C/|∇C| by the differences that the solver's scheme takes: towards the smaller neighbour on each axis,
  // and none where no neighbour is smaller, so that it never points at a blocked cell and only a minimum has
  // length 0. On a tie, where fronts from both sides meet, towards the smaller coordinate.
  glm::vec3 descent(glm::ivec3 at, std::size_t cell) const {
    const float here = in_.cost[cell];
    glm::vec3 down(0.0F);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 low = at;
      glm::ivec3 high = at;
      low[axis] -= 1;
      high[axis] += 1;
      const float c_low = inside(low) ? in_.cost[index(low)] : kUnreachedCost;
      const float c_high = inside(high) ? in_.cost[index(high)] : kUnreachedCost;
      if (std::min(c_low, c_high) < here) {
        down[axis] = c_low <= c_high ? c_low - here : here - c_high;
      }
    }
    const float length = glm::length(down);
    return length > 0.0F ? down / length : down;
  }

  // ∇φ, one-sided at the border. Shorter than 1 where walls on two sides are equally near.
  glm::vec3 wall_normal(glm::ivec3 at) const {
    glm::vec3 gradient(0.0F);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 low = at;
      glm::ivec3 high = at;
      low[axis] = std::max(at[axis] - 1, 0);
      high[axis] = std::min(at[axis] + 1, in_.grid.cells[axis] - 1);
      const auto width = static_cast<float>(high[axis] - low[axis]) * in_.grid.cell;
      if (width > 0.0F) {
        gradient[axis] = (in_.distance[index(high)] - in_.distance[index(low)]) / width;
      }
    }
    const float length = glm::length(gradient);
    return length > 1.0F ? gradient / length : gradient;
  }

  // Takes from a direction near a wall what leads into the wall, all of it at the clearance: between this
  // cell and the blocked one behind it an agent then flies along the wall. What is left is scaled back to
  // length 1.
  glm::vec3 turned(glm::ivec3 at, std::size_t cell, glm::vec3 direction) const {
    const float room = (in_.distance[cell] - in_.clearance) / (kTurnReach * in_.grid.cell);
    if (!(room < 1.0F)) {
      return direction;
    }
    // At an edge, differences make the gradient short, though the wall is on one side; between two walls it
    // vanishes, and nothing is to be turned.
    const glm::vec3 gradient = wall_normal(at);
    const glm::vec3 normal = gradient / std::max(glm::length(gradient), 0.5F);
    const float into = glm::dot(direction, normal);
    if (into >= 0.0F) {
      return direction;
    }
    const glm::vec3 along = direction - (1.0F - smooth(room)) * into * normal;
    const float length = glm::length(along);
    // Head-on against a wall there is no "along"; the scheme's own direction is then the one that is known to
    // go down.
    return length > 0.1F ? along / length : direction;
  }

  // Beside free cells: the mean of those on this side of the wall, with the part into the wall taken off and
  // a push away from it. Deeper: straight out.
  void fill_blocked(glm::ivec3 at, std::size_t cell) {
    const glm::vec3 normal = wall_normal(at);
    const float steepness = glm::length(normal);
    const glm::vec3 out = steepness > 1e-6F ? normal / steepness : glm::vec3(0.0F);
    glm::vec3 direction(0.0F);
    float cost = 0.0F;
    float weight = 0.0F;
    bool across = false;  // a free cell on the other side: the wall is thinner than a cell
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const glm::ivec3 step(i, j, k);
          const glm::ivec3 to = at + step;
          if (!inside(to) || in_.kind[index(to)] != CellKind::kReached) {
            continue;
          }
          const std::size_t neighbour = index(to);
          if (glm::dot(wall_normal(to), out) < -0.3F) {
            across = true;
            continue;
          }
          const float w = 1.0F / glm::dot(glm::vec3(step), glm::vec3(step));
          direction +=
              w * glm::vec3(guide_[4 * neighbour], guide_[4 * neighbour + 1], guide_[4 * neighbour + 2]);
          cost += w * in_.cost[neighbour];
          weight += w;
        }
      }
    }
    if (!(weight > 0.0F)) {
      set(cell, across ? glm::vec3(0.0F) : out, farthest_);
      return;
    }
    direction /= weight;
    const float away = glm::dot(direction, out);
    if (across) {
      // What is away from the wall on this side leads into it on the other, so only "along" is left; the less
      // of it the nearer the wall is, so that beyond the wall the free cell there prevails.
      const glm::vec3 along = direction - away * out;
      const float length = glm::length(along);
      const float strength = std::clamp(2.0F * in_.distance[cell] / in_.clearance, 0.0F, 1.0F);
      set(cell, length > 0.1F ? along * (strength / length) : glm::vec3(0.0F), cost / weight);
      return;
    }
    const float depth = std::clamp((in_.clearance - in_.distance[cell]) / in_.grid.cell, 0.0F, 1.0F);
    const glm::vec3 push = kPush * (1.0F + 2.0F * depth) * out;
    set(cell, direction - std::min(away, 0.0F) * out + push, cost / weight);
  }

  const GuideInput& in_;
  std::span<float> guide_;
  float farthest_ = 0.0F;
};

}  // namespace

void make_guide(const GuideInput& input, std::span<float> guide, int threads, const Progress& progress) {
  GuideMaker maker(input, guide);
  const auto planes = static_cast<std::size_t>(input.grid.cells.z);
  parallel_for(planes, threads, "cost: directions", progress,
               [&](std::size_t z) { maker.free_plane(static_cast<int>(z)); });
  parallel_for(planes, threads, "cost: walls", progress,
               [&](std::size_t z) { maker.blocked_plane(static_cast<int>(z)); });
}

void point_at(glm::vec3 middle, const Grid& grid, std::span<const std::size_t> cells,
              std::span<float> guide) {
  for (const std::size_t cell : cells) {
    const auto nx = static_cast<std::size_t>(grid.cells.x);
    const auto ny = static_cast<std::size_t>(grid.cells.y);
    const glm::vec3 to = middle - grid.center(static_cast<int>(cell % nx), static_cast<int>(cell / nx % ny),
                                              static_cast<int>(cell / nx / ny));
    const float length = glm::length(to);
    const glm::vec3 direction = length > 0.0F ? to / length : glm::vec3(0.0F);
    guide[4 * cell + 0] = direction.x;
    guide[4 * cell + 1] = direction.y;
    guide[4 * cell + 2] = direction.z;
  }
}

}  // namespace mayfly::fields
