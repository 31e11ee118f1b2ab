#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "bench/noise/steering.hpp"
#include "fields/eikonal.hpp"

namespace mayfly::bench {
namespace {

constexpr float kCell = 2.0F;  // m
constexpr int kTicksASolution = 50;
// Agents a m³ from which on they hinder each other, and at which they are slowest.
constexpr float kFree = 0.05F;
constexpr float kCrowded = 0.5F;
constexpr float kSlowest = 0.2F;  // of the cruise speed

class Crowd final : public Steering {
 public:
  explicit Crowd(const Arena& arena) : cruise_(arena.field.cruise_speed) {
    const Box& bounds = arena.scenario.world.bounds;
    grid_ = {bounds.min, kCell, glm::ivec3(glm::round((bounds.max - bounds.min) / kCell))};
    const Box& goal = std::get<fields::BoxShape>(arena.scenario.world.goals[0].shape).box;
    for_each_cell([&](std::size_t, glm::ivec3 c) {
      const glm::vec3 center = grid_.center(c.x, c.y, c.z);
      blocked_.push_back(arena.world.solid.signed_distance(center) < 0.0F);
      goal_.push_back(goal.contains(center));
    });
    density_.resize(grid_.size());
    slowness_.resize(grid_.size());
    cost_.resize(grid_.size());
    flow_.resize(grid_.size());
  }

  void steer(std::span<const glm::vec3> at, std::span<glm::vec3> velocity) override {
    if (tick_++ % kTicksASolution == 0) {
      solve(at);
    }
    for (std::size_t a = 0; a < at.size(); ++a) {
      glm::vec3 v(0);
      float sum = 0.0F;
      around(at[a], [&](std::size_t cell, float weight) {
        if (!blocked_[cell]) {
          v += weight * flow_[cell];
          sum += weight;
        }
      });
      velocity[a] = sum > 0.0F ? v / sum : v;
    }
  }

 private:
  template <class Visit>
  void for_each_cell(Visit visit) const {
    std::size_t cell = 0;
    for (int k = 0; k < grid_.cells.z; ++k) {
      for (int j = 0; j < grid_.cells.y; ++j) {
        for (int i = 0; i < grid_.cells.x; ++i) {
          visit(cell++, glm::ivec3(i, j, k));
        }
      }
    }
  }

  // The eight cells whose centres are around p, with their trilinear weights.
  template <class Visit>
  void around(glm::vec3 p, Visit visit) const {
    const glm::vec3 u = (p - grid_.origin) / kCell - 0.5F;
    const glm::vec3 low = glm::floor(u);
    const glm::vec3 t = u - low;
    for (int n = 0; n < 8; ++n) {
      const glm::ivec3 side(n & 1, n >> 1 & 1, n >> 2);
      const glm::ivec3 c = glm::clamp(glm::ivec3(low) + side, glm::ivec3(0), grid_.cells - 1);
      const glm::vec3 w(side.x != 0 ? t.x : 1 - t.x, side.y != 0 ? t.y : 1 - t.y,
                        side.z != 0 ? t.z : 1 - t.z);
      visit(grid_.index(c.x, c.y, c.z), w.x * w.y * w.z);
    }
  }

  float speed_at(std::size_t cell) const {
    const float crowding = std::clamp((density_[cell] - kFree) / (kCrowded - kFree), 0.0F, 1.0F);
    return cruise_ * (1.0F - (1.0F - kSlowest) * crowding);
  }

  void solve(std::span<const glm::vec3> at) {
    std::fill(density_.begin(), density_.end(), 0.0F);
    for (const glm::vec3& p : at) {
      around(p, [&](std::size_t cell, float weight) { density_[cell] += weight / (kCell * kCell * kCell); });
    }
    // Treuille 2006, Eq. 4: (length + time) a metre of way, the two weighted alike.
    for (std::size_t cell = 0; cell < grid_.size(); ++cell) {
      slowness_[cell] = blocked_[cell] ? 0.0F : 1.0F + cruise_ / speed_at(cell);
      cost_[cell] = goal_[cell] ? 0.0F : fields::kUnreachedCost;
    }
    static_cast<void>(fields::solve_eikonal(grid_, slowness_, cost_, 1));
    for_each_cell([&](std::size_t cell, glm::ivec3 c) {
      const glm::vec3 down = descent(cell, c);
      const float length = glm::length(down);
      flow_[cell] = length > 0.0F ? down * (speed_at(cell) / length) : glm::vec3(0);
    });
  }

  // −∇C by differences towards the cheaper neighbours, as the solver sees them.
  glm::vec3 descent(std::size_t cell, glm::ivec3 c) const {
    glm::vec3 down(0);
    for (int axis = 0; axis < 3; ++axis) {
      float fall = 0.0F;
      for (const int side : {-1, 1}) {
        glm::ivec3 next = c;
        next[axis] += side;
        if (next[axis] < 0 || next[axis] >= grid_.cells[axis]) {
          continue;
        }
        const float gain = cost_[cell] - cost_[grid_.index(next.x, next.y, next.z)];
        if (std::isfinite(gain) && gain > fall) {
          fall = gain;
          down[axis] = static_cast<float>(side) * gain;
        }
      }
    }
    return down;
  }

  float cruise_;
  Grid grid_;
  std::vector<bool> blocked_, goal_;
  std::vector<float> density_, slowness_, cost_;
  std::vector<glm::vec3> flow_;
  int tick_ = 0;
};

}  // namespace

std::unique_ptr<Steering> make_crowd(const Arena& arena) {
  return std::make_unique<Crowd>(arena);
}

}  // namespace mayfly::bench
