#include "fields/oriented_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "fields/geometry.hpp"
#include "tests/reference/triangle_distance.hpp"
#include "tests/unit/fields_geometry/meshes.hpp"

namespace mayfly::fields {
namespace {

glm::vec3 any_point(std::mt19937& random, float size) {
  std::normal_distribution<float> any(0.0F, size);
  return {any(random), any(random), any(random)};
}

// Patches that are flat, askew, thin as a line, folded on themselves, or a single point.
std::vector<std::vector<glm::vec3>> patches(std::mt19937& random) {
  std::vector<std::vector<glm::vec3>> all;
  for (int n = 0; n < 200; ++n) {
    std::vector<glm::vec3> corners;
    const glm::vec3 normal = glm::normalize(any_point(random, 1.0F));
    const float flatness = n % 4 == 0 ? 0.0F : n % 4 == 1 ? 1e-4F : 1.0F;
    for (int corner = 0; corner < 3 * (1 + n % 7); ++corner) {
      const glm::vec3 p = any_point(random, 1.0F);
      corners.push_back(p - (1.0F - flatness) * glm::dot(p, normal) * normal);
    }
    all.push_back(corners);
  }
  const glm::vec3 a(1, 2, 3);
  const glm::vec3 b(4, 2, 3.5F);
  all.push_back({a, a, a});
  all.push_back({a, b, 0.5F * (a + b)});
  all.push_back({a, b, {0, 0, 1}, b, a, {0, 0, 1}});  // both faces of a sheet
  return all;
}

TEST(OrientedBox, IsNeverFartherThanWhatItHolds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  for (const std::vector<glm::vec3>& corners : patches(random)) {
    const OrientedBox box = box_around(corners, 1e-5F);
    for (int n = 0; n < 200; ++n) {
      const float far = n % 3 == 0 ? 1.0F : n % 3 == 1 ? 30.0F : 1e4F;
      const glm::vec3 p = any_point(random, far);
      const std::size_t triangle = 3 * (random() % (corners.size() / 3));
      const float s = share(random);
      const float t = (1.0F - s) * share(random);
      const glm::dvec3 inside = glm::dvec3(corners[triangle]) * static_cast<double>(1.0F - s - t) +
                                glm::dvec3(corners[triangle + 1]) * static_cast<double>(s) +
                                glm::dvec3(corners[triangle + 2]) * static_cast<double>(t);
      const double truth = glm::length(glm::dvec3(p) - inside);
      ASSERT_LE(least_distance_squared(box, std::array{p.x, p.y, p.z}), truth * truth);
    }
  }
}

TEST(OrientedBox, LiesAlongAFlatPatch) {
  const glm::vec3 normal = glm::normalize(glm::vec3(1, 2, 3));
  const glm::vec3 u = glm::normalize(glm::cross(normal, glm::vec3(0, 0, 1)));
  const glm::vec3 v = glm::cross(normal, u);
  const OrientedBox box =
      box_around(std::vector<glm::vec3>{glm::vec3(0), u, u + v, glm::vec3(0), u + v, v}, 0.0F);
  const glm::vec3 above = 0.5F * (u + v) + 10.0F * normal;
  EXPECT_NEAR(std::sqrt(least_distance_squared(box, std::array{above.x, above.y, above.z})), 10.0F, 1e-3F);
}

TEST(OrientedBox, EightPointsSeeWhatOneSees) {
  std::mt19937 random(2);
  for (const std::vector<glm::vec3>& corners : patches(random)) {
    const OrientedBox box = box_around(corners, 1e-5F);
    std::array<kernels::F, 3> eight{};
    std::array<glm::vec3, 8> points;
    for (int lane = 0; lane < 8; ++lane) {
      points[static_cast<std::size_t>(lane)] = any_point(random, 5.0F);
      for (int axis = 0; axis < 3; ++axis) {
        eight[static_cast<std::size_t>(axis)][lane] = points[static_cast<std::size_t>(lane)][axis];
      }
    }
    const kernels::F squared = least_distance_squared(box, eight);
    for (int lane = 0; lane < 8; ++lane) {
      const glm::vec3& p = points[static_cast<std::size_t>(lane)];
      EXPECT_EQ(squared[lane], least_distance_squared(box, std::array{p.x, p.y, p.z}));
    }
  }
}

// A mesh far from the origin, asked from near and from very far: nothing near may be missed for rounding.
TEST(OrientedBox, TheTreeFindsTheNearestWhereverTheMeshIs) {
  const test::Folder folder;
  for (const float far : {0.0F, 5e3F}) {
    TriangleMesh mesh = test::torus(1.5, 0.4, 40, 16);
    for (glm::vec3& vertex : mesh.vertices) {
      vertex += glm::vec3(far, -far, 0.5F * far);
    }
    const auto file = folder.write("m" + std::to_string(static_cast<int>(far)) + ".obj", test::as_obj(mesh));
    const auto loaded = load_mesh(file);
    ASSERT_TRUE(loaded);
    const PlacedShape shape{MeshShape{file, {}, {}, 1.0F, {}, true, 0.01F}, {}};
    const auto geometry = Geometry::make({&shape, 1}, 1.0F);
    ASSERT_TRUE(geometry) << to_string(geometry.error());
    const reference::MeshDistance truth(loaded->vertices, loaded->triangles);
    std::mt19937 random(3);
    for (int n = 0; n < 300; ++n) {
      const glm::vec3 p = glm::vec3(far, -far, 0.5F * far) + any_point(random, n % 2 == 0 ? 2.0F : 1e4F);
      const double expected = std::abs(truth.signed_distance(p)) - 0.005;
      EXPECT_NEAR(geometry->signed_distance(p), expected, 1e-6 * (1.0 + expected));
    }
  }
}

}  // namespace
}  // namespace mayfly::fields
