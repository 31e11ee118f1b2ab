#include <cmath>
#include <glm/geometric.hpp>

#include "bench/noise/neighbours.hpp"
#include "bench/noise/steering.hpp"

namespace mayfly::bench {
namespace {

constexpr float kSight = 4.0F;     // m, of alignment and cohesion
constexpr float kPersonal = 1.0F;  // m, of separation
// What each behaviour asks for, m/s².
constexpr float kSeparating = 4.0F;
constexpr float kAligning = 2.0F;
constexpr float kCohering = 1.0F;
constexpr float kFollowing = 2.0F;

glm::vec3 unit(glm::vec3 v) {
  const float length = glm::length(v);
  return length < 1e-9F ? glm::vec3(0) : v / length;
}
class Boids final : public Steering {
 public:
  explicit Boids(const Arena& arena) : arena_(arena) {}

  void steer(std::span<const glm::vec3> at, std::span<glm::vec3> velocity) override {
    guided_.resize(at.size());
    guided_velocities(arena_, at, guided_);
    if (own_.empty()) {
      own_ = guided_;
    }
    const Neighbours neighbours(at, kSight);
    for (std::size_t a = 0; a < at.size(); ++a) {
      const glm::vec3 asked = asked_of(at, a, neighbours);
      velocity[a] = arena_.field.cruise_speed * unit(own_[a] + static_cast<float>(kPeriod) * asked);
    }
    own_.assign(velocity.begin(), velocity.end());
  }

 private:
  // The acceleration that its behaviours ask an agent for.
  glm::vec3 asked_of(std::span<const glm::vec3> at, std::size_t self, const Neighbours& neighbours) const {
    glm::vec3 away(0), heading(0), center(0);
    neighbours.for_each(at[self], kSight, [&](std::size_t other, float distance2) {
      if (other == self) {
        return;
      }
      if (distance2 < kPersonal * kPersonal && distance2 > 0.0F) {
        away += (at[self] - at[other]) / distance2;
      }
      heading += own_[other] - own_[self];
      center += at[other] - at[self];
    });
    return kFollowing * unit(guided_[self] - own_[self]) + kSeparating * unit(away) +
           kAligning * unit(heading) + kCohering * unit(center);
  }

  const Arena& arena_;
  std::vector<glm::vec3> own_, guided_;
};

}  // namespace

std::unique_ptr<Steering> make_boids(const Arena& arena) {
  return std::make_unique<Boids>(arena);
}

}  // namespace mayfly::bench
