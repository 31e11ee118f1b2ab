#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fields/mesh.hpp"
#include "fields/mesh_weld.hpp"
#include "tests/unit/fields_geometry/meshes.hpp"

namespace mayfly::fields {
namespace {

using test::append;
using test::cube;
using testing::HasSubstr;

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    sum += glm::dot(glm::dvec3(mesh.vertices[t.x]),
                    glm::cross(glm::dvec3(mesh.vertices[t.y]), glm::dvec3(mesh.vertices[t.z])));
  }
  return sum / 6.0;
}

const TriangleMesh kCube = cube(glm::vec3(-1), glm::vec3(1));

TEST(CheckClosed, a_cube_is) {
  const MeshReport report = check_closed(kCube);
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.crowded_edges + report.inconsistent_edges + report.inside_out, 0U);
}

TEST(CheckClosed, names_each_hole) {
  TriangleMesh mesh = kCube;
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);  // the floor, z = −1
  mesh.triangles.pop_back();                                                 // half of x = 1
  EXPECT_EQ(check_closed(mesh).holes.size(), 2U) << "they touch in a corner only";
  TriangleMesh apart = test::sphere({0, 0, 0}, 2, 2);
  append(apart, cube({5, 0, 0}, {6, 1, 1}));
  apart.triangles.pop_back();
  apart.triangles.erase(apart.triangles.begin());
  const std::vector<Hole> holes = check_closed(apart).holes;
  ASSERT_EQ(holes.size(), 2U);
  EXPECT_EQ(holes[0].edges, 3U);
  EXPECT_NEAR(holes[0].center.x, 6.0, 1e-6);  // the larger: half the cube's side x = 6
  EXPECT_NEAR(holes[0].width, 1.0, 1e-6);
  EXPECT_THAT(describe_holes(holes),
              HasSubstr("2 holes: a loop of 3 edges around (6, 0.5, 0.5), 1 m wide; a loop"));
}

TEST(MakeSolid, refuses_an_open_mesh_with_its_holes_and_a_hint) {
  TriangleMesh mesh = kCube;
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
  const Result<TriangleMesh> solid = make_solid(mesh, "x.obj");
  ASSERT_FALSE(solid);
  EXPECT_THAT(to_string(solid.error()),
              HasSubstr("open mesh 'x.obj'; found 1 hole: a loop of 4 edges around (0, 0, -1), 2 m wide"));
  EXPECT_THAT(to_string(solid.error()), HasSubstr("thin: true"));
}

TEST(MakeSolid, mends_triangles_that_face_the_wrong_way) {
  for (std::size_t i = 0; i < kCube.triangles.size(); ++i) {
    TriangleMesh mesh = kCube;
    std::swap(mesh.triangles[i].x, mesh.triangles[i].y);
    EXPECT_EQ(check_closed(mesh).inconsistent_edges, 3U);
    const Result<TriangleMesh> solid = make_solid(mesh, "x");
    ASSERT_TRUE(solid) << to_string(solid.error());
    EXPECT_NEAR(volume(*solid), 8.0, 1e-12);
    EXPECT_EQ(check_closed(*solid).inconsistent_edges, 0U);
  }
}

TEST(MakeSolid, turns_what_is_inside_out_but_not_a_cavity) {
  EXPECT_EQ(check_closed(test::turned(kCube)).inside_out, 1U);
  EXPECT_NEAR(volume(*make_solid(test::turned(kCube), "x")), 8.0, 1e-12);
  TriangleMesh shell = kCube;
  append(shell, test::turned(cube(glm::vec3(-0.5F), glm::vec3(0.5F))));
  EXPECT_EQ(check_closed(shell).inside_out, 0U);
  EXPECT_NEAR(volume(*make_solid(shell, "x")), 7.0, 1e-12);
  TriangleMesh pair = kCube;
  append(pair, test::turned(cube(glm::vec3(3), glm::vec3(4))));
  EXPECT_NEAR(volume(*make_solid(pair, "x")), 9.0, 1e-5);
}

TEST(MakeSolid, bodies_that_share_an_edge_are_two) {
  TriangleMesh mesh = kCube;
  append(mesh, test::turned(cube({1, 1, -1}, {2, 2, 1})));
  weld(mesh);
  const MeshReport report = check_closed(mesh);
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.crowded_edges, 1U);
  EXPECT_EQ(report.components, 2U);
  const Result<TriangleMesh> solid = make_solid(mesh, "x");
  ASSERT_TRUE(solid) << to_string(solid.error());
  EXPECT_NEAR(volume(*solid), 10.0, 1e-5);
}

TEST(MakeSolid, refuses_a_surface_with_one_side) {
  const TriangleMesh bottle = test::klein_bottle(12, 10);
  EXPECT_TRUE(check_closed(bottle).closed());
  const Result<TriangleMesh> solid = make_solid(bottle, "bottle");
  ASSERT_FALSE(solid);
  EXPECT_THAT(to_string(solid.error()), HasSubstr("mesh 'bottle' has no inside"));
}

TEST(Weld, joins_seams_and_drops_what_loses_a_corner) {
  TriangleMesh soup;
  for (const glm::uvec3& t : kCube.triangles) {
    const auto first = static_cast<glm::uint>(soup.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      // Apart by less than 1e-6 of the diagonal, differently for each triangle.
      soup.vertices.push_back(kCube.vertices[t[corner]] + 1e-7F * static_cast<float>(first));
    }
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  soup.triangles.emplace_back(0, 1, 1);
  soup.vertices.emplace_back(
      50.0F);  // no triangle's: must not widen the tolerance's box into a weld of everything
  weld(soup);
  EXPECT_EQ(soup.triangles.size(), 12U);
  EXPECT_EQ(soup.vertices.size(), 8U);
  EXPECT_TRUE(check_closed(soup).closed());
}

}  // namespace
}  // namespace mayfly::fields
