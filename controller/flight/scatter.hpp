// Scattering agents at random without crowding: reproducible draws, and a record of who has which place.
#pragma once

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <vector>

namespace mayfly {

// What a draw is for. Draws with different keys know nothing of each other, whatever the order they are made
// in.
struct DrawKey {
  std::uint64_t seed = 0;
  std::uint32_t stream = 0;  // a constant of whoever draws
  std::uint32_t swarm = 0, agent = 0, attempt = 0;
};

inline r123::Philox4x32::ctr_type draw_words(const DrawKey& key) {
  return r123::Philox4x32()(
      {{key.agent, key.attempt, key.swarm, key.stream}},
      {{static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32U)}});
}

// Uniform in [0, 1)³.
inline glm::vec3 draw_unit_cube(const DrawKey& key) {
  const auto words = draw_words(key);
  const auto unit = [](std::uint32_t word) { return static_cast<float>(word >> 8U) * 0x1p-24F; };
  return {unit(words[0]), unit(words[1]), unit(words[2])};
}

// The places taken so far, in cubes as wide as the largest separation.
class Taken {
 public:
  explicit Taken(float cell) : cell_(std::max(cell, 1e-3F)) {}

  // Whether p keeps the sum of the two halves to everybody who has a place.
  bool is_free(glm::vec3 p, float half_separation) const {
    const glm::ivec3 c = cell_of(p);
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          if (blocks(c + glm::ivec3(i, j, k), p, half_separation)) {
            return false;
          }
        }
      }
    }
    return true;
  }
  void take(glm::vec3 p, float half_separation) {
    cells_[key_of(cell_of(p))].push_back({p, half_separation});
  }

 private:
  struct Body {
    glm::vec3 at;
    float half_separation;
  };

  glm::ivec3 cell_of(glm::vec3 p) const {
    return {static_cast<int>(std::floor(p.x / cell_)), static_cast<int>(std::floor(p.y / cell_)),
            static_cast<int>(std::floor(p.z / cell_))};
  }
  static std::uint64_t key_of(glm::ivec3 c) {
    constexpr std::uint64_t kMask = (std::uint64_t{1} << 21U) - 1U;
    const auto part = [](int v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)) & kMask; };
    return part(c.x) | part(c.y) << 21U | part(c.z) << 42U;
  }
  bool blocks(glm::ivec3 cell, glm::vec3 p, float half_separation) const {
    const auto found = cells_.find(key_of(cell));
    return found != cells_.end() &&
           std::any_of(found->second.begin(), found->second.end(), [&](const Body& body) {
             const glm::vec3 d = body.at - p;
             const float least = body.half_separation + half_separation;
             return d.x * d.x + d.y * d.y + d.z * d.z < least * least;
           });
  }

  float cell_;
  std::unordered_map<std::uint64_t, std::vector<Body>> cells_;
};

}  // namespace mayfly
