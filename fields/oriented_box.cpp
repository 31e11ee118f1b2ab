#include "fields/oriented_box.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace mayfly::fields {
namespace {

using Axes = std::array<glm::vec3, 3>;

// The sum of the triangles' normals by area, each turned to the side of the first: of a thin sheet's two
// faces, too, the sum is the sheet's normal.
glm::vec3 mean_normal(std::span<const glm::vec3> corners) {
  glm::vec3 sum(0.0F);
  for (std::size_t at = 0; at + 2 < corners.size(); at += 3) {
    const glm::vec3 normal = glm::cross(corners[at + 1] - corners[at], corners[at + 2] - corners[at]);
    sum += glm::dot(normal, sum) < 0.0F ? -normal : normal;
  }
  return sum;
}

// The normal, and the direction across it in which the patch reaches farthest from its first corner.
// Whatever comes out is a frame of its own accord or not used: see box_around.
Axes axes_along(std::span<const glm::vec3> corners) {
  const glm::vec3 normal = glm::normalize(mean_normal(corners));
  glm::vec3 longest(0.0F);
  for (const glm::vec3& corner : corners) {
    const glm::vec3 to = corner - corners[0];
    const glm::vec3 across = to - glm::dot(to, normal) * normal;
    longest = glm::dot(across, across) > glm::dot(longest, longest) ? across : longest;
  }
  const glm::vec3 x = glm::normalize(longest);
  return {x, glm::normalize(glm::cross(normal, x)), normal};
}

bool orthonormal(const Axes& axes) {
  constexpr float kRounding = 1e-5F;
  bool good = true;
  for (std::size_t i = 0; i < 3; ++i) {
    good = good && std::abs(glm::dot(axes[i], axes[i]) - 1.0F) < kRounding &&
           std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) < kRounding;
  }
  return good;  // not a number is not
}

OrientedBox box_along(const Axes& axes, std::span<const glm::vec3> corners) {
  glm::vec3 low(0.0F);
  glm::vec3 high(0.0F);
  for (std::size_t at = 0; at < corners.size(); ++at) {
    const glm::vec3& p = corners[at];
    const glm::vec3 u(glm::dot(p, axes[0]), glm::dot(p, axes[1]), glm::dot(p, axes[2]));
    low = at == 0 ? u : glm::min(low, u);
    high = at == 0 ? u : glm::max(high, u);
  }
  const glm::vec3 middle = 0.5F * (low + high);
  OrientedBox box;
  box.center = middle.x * axes[0] + middle.y * axes[1] + middle.z * axes[2];
  box.axes = axes;
  box.half = 0.5F * (high - low);
  return box;
}

float surface(const OrientedBox& box) {
  return box.half.x * box.half.y + box.half.y * box.half.z + box.half.z * box.half.x;
}

}  // namespace

OrientedBox box_around(std::span<const glm::vec3> corners, float slack) {
  const Axes straight{glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)};
  OrientedBox best = box_along(straight, corners);
  // A triangle without area, or so thin that nothing is sure, stays in its straight box.
  if (const Axes askew = axes_along(corners); orthonormal(askew)) {
    const OrientedBox other = box_along(askew, corners);
    best = surface(other) < surface(best) ? other : best;
  }
  best.half += slack;
  return best;
}

}  // namespace mayfly::fields
