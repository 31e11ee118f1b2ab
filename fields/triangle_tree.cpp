#include "fields/triangle_tree.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "fields/double8.hpp"
#include "fields/oriented_box.hpp"
#include "fields/scan_lines.hpp"

namespace mayfly::fields {
namespace {

constexpr std::size_t kLeafTriangles = 4;
// A box's link holds the count of a leaf's triangles in its lowest bits.
constexpr std::uint32_t kCountBits = 3;
constexpr std::uint32_t kCountMask = (1U << kCountBits) - 1;
static_assert(kLeafTriangles <= kCountMask && kMaxMeshTriangles < (1U << (32 - kCountBits)));
// Of the tree's diagonal: many times what floats of its size round away.
constexpr float kBoxSlack = 2e-6F;
// What is left of a bound when it becomes a float.
constexpr float kNarrowing = 1.0F + 1e-6F;
// Halving 2³² triangles ends after 32 levels.
constexpr std::size_t kStack = 40;

Box bounds_of(std::span<const std::uint32_t> order, std::span<const TriangleTree::Corners> triangles) {
  Box box{triangles[order[0]][0], triangles[order[0]][0]};
  for (const std::uint32_t t : order) {
    for (const glm::vec3& corner : triangles[t]) {
      box.min = glm::min(box.min, corner);
      box.max = glm::max(box.max, corner);
    }
  }
  return box;
}

glm::vec3 middle(const TriangleTree::Corners& corners) {  // of the bounding box, doubled
  return glm::min(glm::min(corners[0], corners[1]), corners[2]) +
         glm::max(glm::max(corners[0], corners[1]), corners[2]);
}

int longest_axis_of_middles(std::span<const std::uint32_t> order,
                            std::span<const TriangleTree::Corners> triangles) {
  glm::vec3 low = middle(triangles[order[0]]);
  glm::vec3 high = low;
  for (const std::uint32_t t : order) {
    low = glm::min(low, middle(triangles[t]));
    high = glm::max(high, middle(triangles[t]));
  }
  const glm::vec3 side = high - low;
  return side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
}

glm::dvec3 any_perpendicular(const glm::dvec3& unit) {
  const glm::dvec3 other = std::abs(unit.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(unit, other));
}

double inverse_or_zero(double a) {
  return a > 0.0 ? 1.0 / a : 0.0;
}

TriangleFrame make_frame(const TriangleTree::Corners& corners) {
  std::array<glm::dvec3, 3> p{corners[0], corners[1], corners[2]};
  const auto side_squared = [&](std::size_t i) {
    const glm::dvec3 side = p[(i + 1) % 3] - p[i];
    return glm::dot(side, side);
  };
  std::size_t longest = 0;
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    longest = side_squared(i) > side_squared(longest) ? i : longest;
  }
  std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(longest), p.end());
  TriangleFrame frame;
  frame.origin = p[0];
  frame.length = glm::length(p[1] - p[0]);
  frame.x = frame.length > 0.0 ? (p[1] - p[0]) / frame.length : glm::dvec3(1, 0, 0);
  const glm::dvec3 apex = p[2] - p[0];
  frame.apex_x = glm::dot(apex, frame.x);
  const glm::dvec3 height = apex - frame.apex_x * frame.x;
  frame.apex_y = glm::length(height);
  frame.y = frame.apex_y > 0.0 ? height / frame.apex_y : any_perpendicular(frame.x);
  // Cancellation may have left y not quite perpendicular in a triangle that is nearly a line.
  frame.y = glm::normalize(frame.y - glm::dot(frame.y, frame.x) * frame.x);
  frame.z = glm::cross(frame.x, frame.y);
  const double far_x = frame.apex_x - frame.length;
  frame.inverse_near = inverse_or_zero(frame.apex_x * frame.apex_x + frame.apex_y * frame.apex_y);
  frame.inverse_far = inverse_or_zero(far_x * far_x + frame.apex_y * frame.apex_y);
  return frame;
}

template <class T>
T dot(const std::array<T, 3>& a, const glm::dvec3& b) {
  return a[0] * b.x + a[1] * b.y + a[2] * b.z;
}

// Squared distance in the triangle's plane to the segment from the frame's (from_x, 0) to the apex.
template <class T>
T side_distance_squared(const T& x, const T& y, double dx, double dy, double inverse_squared) {
  const T along = clamp((x * dx + y * dy) * inverse_squared, 0.0, 1.0);
  const T off_x = x - along * dx;
  const T off_y = y - along * dy;
  return off_x * off_x + off_y * off_y;
}

template <class T>
T triangle_distance_squared(const TriangleFrame& frame, const std::array<T, 3>& point) {
  const std::array<T, 3> from{point[0] - frame.origin.x, point[1] - frame.origin.y,
                              point[2] - frame.origin.z};
  const T x = dot(from, frame.x);
  const T y = dot(from, frame.y);
  const T z = dot(from, frame.z);
  const T end_x = x - frame.length;
  const double far_x = frame.apex_x - frame.length;
  const T off_base = x - clamp(x, 0.0, frame.length);
  const T base = off_base * off_base + y * y;
  const T near_side = side_distance_squared(x, y, frame.apex_x, frame.apex_y, frame.inverse_near);
  const T far_side = side_distance_squared(end_x, y, far_x, frame.apex_y, frame.inverse_far);
  const auto inside =
      (y >= 0.0) & (y * frame.apex_x - x * frame.apex_y <= 0.0) & (y * far_x - end_x * frame.apex_y >= 0.0);
  return select(inside, splat<T>(0.0), min(base, min(near_side, far_side))) + z * z;
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles) {
    triangles.push_back({mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]});
  }
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  bounds_ = bounds_of(order, triangles);
  nodes_.reserve(triangles.size());
  build(order, triangles, 0);
  corners_.reserve(order.size());
  frames_.reserve(order.size());
  for (const std::uint32_t t : order) {
    corners_.push_back(triangles[t]);
    frames_.push_back(make_frame(triangles[t]));
  }
  middle_ = 0.5 * (glm::dvec3(bounds_.min) + glm::dvec3(bounds_.max));
  fit_boxes();
}

TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;
TriangleTree::~TriangleTree() = default;

// Children come after their parents, so backwards every node knows where its triangles begin and end.
void TriangleTree::fit_boxes() {
  std::vector<glm::vec3> corners;
  corners.reserve(3 * corners_.size());
  for (const Corners& triangle : corners_) {
    for (const glm::vec3& corner : triangle) {
      corners.emplace_back(glm::dvec3(corner) - middle_);
    }
  }
  const float slack = kBoxSlack * glm::length(bounds_.max - bounds_.min);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> triangles(nodes_.size());
  boxes_.resize(nodes_.size());
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    triangles[n] = node.count > 0 ? std::pair{node.next, node.next + node.count}
                                  : std::pair{triangles[n + 1].first, triangles[node.next].second};
    const auto [first, end] = triangles[n];
    boxes_[n] = box_around(std::span(corners).subspan(3 * first, 3 * (end - first)), slack);
    boxes_[n].link = node.count > 0 ? node.next << kCountBits | node.count : node.next << kCountBits;
  }
}

void TriangleTree::build(std::span<std::uint32_t> order, std::span<const Corners> triangles,
                         std::uint32_t first) {
  const Box box = bounds_of(order, triangles);
  const std::size_t self = nodes_.size();
  if (order.size() <= kLeafTriangles) {
    nodes_.push_back({box.min, first, box.max, static_cast<std::uint32_t>(order.size())});
    return;
  }
  nodes_.push_back({box.min, 0, box.max, 0});
  const int axis = longest_axis_of_middles(order, triangles);
  const std::size_t half = order.size() / 2;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float at_a = middle(triangles[a])[axis];
                     const float at_b = middle(triangles[b])[axis];
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
  build(order.first(half), triangles, first);
  nodes_[self].next = static_cast<std::uint32_t>(nodes_.size());
  build(order.subspan(half), triangles, first + static_cast<std::uint32_t>(half));
}

template <class T>
void TriangleTree::try_triangle(std::uint32_t triangle, const std::array<T, 3>& point, T& best_squared,
                                std::uint32_t& hint) const noexcept {
  const T squared = triangle_distance_squared(frames_[triangle], point);
  if (any(squared < best_squared)) {
    best_squared = min(squared, best_squared);
    hint = triangle;
  }
}

template <class T>
void TriangleTree::nearest(const std::array<T, 3>& point, T& best_squared,
                           std::uint32_t& hint) const noexcept {
  using L = typename Narrow<T>::Type;
  struct Pending {
    std::uint32_t box;
    L squared;
  };
  const std::array<L, 3> from_middle{narrow(point[0] - middle_.x), narrow(point[1] - middle_.y),
                                     narrow(point[2] - middle_.z)};
  // Filling it would cost more than a search. NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  std::array<Pending, kStack> stack;
  std::size_t depth = 0;
  L limit = narrow(best_squared) * kNarrowing;
  Pending at{0, least_distance_squared(boxes_[0], from_middle)};
  if (hint != kNoHint && any_below(at.squared, limit)) {
    try_triangle(hint, point, best_squared, hint);
    limit = narrow(best_squared) * kNarrowing;
  }
  for (;;) {
    if (any_below(at.squared, limit)) {
      const std::uint32_t link = boxes_[at.box].link;
      const std::uint32_t count = link & kCountMask;
      const std::uint32_t next = link >> kCountBits;
      if (count == 0) {
        const Pending left{at.box + 1, least_distance_squared(boxes_[at.box + 1], from_middle)};
        const Pending right{next, least_distance_squared(boxes_[next], from_middle)};
        const bool left_first = first_lane(left.squared) <= first_lane(right.squared);
        if (const Pending& later = left_first ? right : left; any_below(later.squared, limit)) {
          stack[depth++] = later;
        }
        at = left_first ? left : right;
        continue;
      }
      for (std::uint32_t i = 0; i < count; ++i) {
        try_triangle(next + i, point, best_squared, hint);
      }
      limit = narrow(best_squared) * kNarrowing;
    }
    if (depth == 0) {
      return;
    }
    at = stack[--depth];
  }
}

template void TriangleTree::nearest<double>(const std::array<double, 3>&, double&,
                                            std::uint32_t&) const noexcept;
template void TriangleTree::nearest<Double8>(const std::array<Double8, 3>&, Double8&,
                                             std::uint32_t&) const noexcept;

int TriangleTree::winding(const glm::dvec3& point) const noexcept {
  std::array<std::uint32_t, kStack> stack;  // NOLINT(cppcoreguidelines-pro-type-member-init): as above
  std::size_t depth = 0;
  stack[depth++] = 0;
  int winding = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (point.x < static_cast<double>(node.min.x) || point.y < static_cast<double>(node.min.y) ||
        point.y > static_cast<double>(node.max.y) || point.z < static_cast<double>(node.min.z) ||
        point.z > static_cast<double>(node.max.z)) {
      continue;
    }
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const Corners& t = corners_[node.next + i];
      const int passes = crossing(t[0], t[1], t[2], point.y, point.z);
      winding += passes != 0 && crossing_x(t[0], t[1], t[2], point.y, point.z) < point.x ? passes : 0;
    }
    if (node.count == 0) {
      stack[depth++] = index + 1;
      stack[depth++] = node.next;
    }
  }
  return winding;
}

}  // namespace mayfly::fields
