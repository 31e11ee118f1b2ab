// A bounding-volume hierarchy over the triangles of one mesh: nearest distance and winding number.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/grid.hpp"
#include "fields/mesh.hpp"

namespace mayfly::fields {

struct OrientedBox;

// One triangle in its own frame: the longest side runs from the origin along +x, the apex lies above it, z is
// the normal. Distances in an orthonormal frame stay exact however thin the triangle is.
struct TriangleFrame {
  glm::dvec3 origin{0.0}, x{0.0}, y{0.0}, z{0.0};
  double length = 0.0;                // of the longest side
  double apex_x = 0.0, apex_y = 0.0;  // 0 ≤ apex_x ≤ length, apex_y ≥ 0
  double inverse_near = 0.0,
         inverse_far = 0.0;  // 1/length² of the sides origin–apex and end–apex, 0 for none
};

class TriangleTree {
 public:
  using Corners = std::array<glm::vec3, 3>;

  static constexpr std::uint32_t kNoHint = ~std::uint32_t{0};

  // At least one triangle.
  explicit TriangleTree(const TriangleMesh& mesh);
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;
  ~TriangleTree();

  // Lowers `best_squared` (m²) to the squared distance from `point` to the nearest triangle, where that is
  // less. T is double, or Double8 for eight points near each other. `hint` is a triangle likely to be near,
  // or kNoHint; it leaves with the last one that improved anything. The result does not depend on the hint.
  template <class T>
  void nearest(const std::array<T, 3>& point, T& best_squared, std::uint32_t& hint) const noexcept;

  // Sum of signed crossings of the line from x = −∞ to `point`, see fields/scan_lines.hpp.
  int winding(const glm::dvec3& point) const noexcept;

  const Box& bounds() const noexcept { return bounds_; }
  std::span<const Corners> triangles() const noexcept { return corners_; }

 private:
  // Depth first: an inner node's first child follows it. A leaf has count > 0 and starts at triangle `next`.
  struct Node {
    glm::vec3 min;
    std::uint32_t next = 0;  // the second child, or the first triangle
    glm::vec3 max;
    std::uint32_t count = 0;
  };

  void build(std::span<std::uint32_t> order, std::span<const Corners> triangles, std::uint32_t first);
  void fit_boxes();
  template <class T>
  void try_triangle(std::uint32_t triangle, const std::array<T, 3>& point, T& best_squared,
                    std::uint32_t& hint) const noexcept;

  Box bounds_;
  glm::dvec3 middle_{0.0};  // what boxes are relative to
  std::vector<Node> nodes_;
  std::vector<OrientedBox> boxes_;  // one a node
  std::vector<Corners> corners_;    // in the order of the leaves
  std::vector<TriangleFrame> frames_;
};

}  // namespace mayfly::fields
