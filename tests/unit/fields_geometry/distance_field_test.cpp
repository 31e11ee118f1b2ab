#include "fields/distance_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/vector_relational.hpp>

#include "fields/make_grid.hpp"
#include "tests/reference/triangle_distance.hpp"
#include "tests/unit/fields_geometry/meshes.hpp"

namespace mayfly::fields {
namespace {

using test::append;
using test::cube;
using test::Folder;

PlacedShape placed(const std::filesystem::path& file) {
  return {MeshShape{file, {}, {}, 1.0F, {}, false, {}}, {}};
}

Geometry must(Result<Geometry> geometry) {
  if (!geometry) {
    ADD_FAILURE() << to_string(geometry.error());
    return *Geometry::make({}, 1.0F);
  }
  return std::move(*geometry);
}

DistanceField field_of(const Geometry& geometry, const Grid& grid, int threads = 2) {
  Result<DistanceField> field = build_distance_field(geometry, grid, threads, {});
  EXPECT_TRUE(field) << to_string(field.error());
  return field ? std::move(*field) : DistanceField{};
}

void for_each_cell(const Grid& grid, const std::function<void(std::size_t, glm::vec3)>& visit) {
  for (int k = 0; k < grid.cells.z; ++k) {
    for (int j = 0; j < grid.cells.y; ++j) {
      for (int i = 0; i < grid.cells.x; ++i) {
        visit(grid.index(i, j, k), grid.center(i, j, k));
      }
    }
  }
}

// Where the surface itself runs through a cell's centre, both signs are right.
constexpr double kOnSurface = 1e-5;

// Every `stride`-th cell against brute force: the 1e-4 of a cell, and the sign.
void expect_matches(const DistanceField& field, const reference::MeshDistance& truth,
                    const std::function<bool(glm::vec3)>& inside, std::size_t stride) {
  std::size_t wrong_signs = 0;
  double largest = 0.0;
  for_each_cell(field.grid, [&](std::size_t index, glm::vec3 center) {
    if (index % stride != 0) {
      return;
    }
    const double signed_truth = truth.signed_distance(center);
    const double expected = std::abs(signed_truth);
    const bool is_inside = inside ? inside(center) : signed_truth < 0.0;
    const double got = static_cast<double>(field.distance[index]);
    largest = std::max(largest, std::abs(std::abs(got) - expected));
    wrong_signs += expected > kOnSurface && (got < 0.0) != is_inside ? 1 : 0;
  });
  EXPECT_LE(largest, 1e-4 * static_cast<double>(field.grid.cell));
  EXPECT_EQ(wrong_signs, 0U);
}

struct Made {
  std::string name;
  TriangleMesh mesh;
  std::function<bool(glm::vec3)> inside;  // empty: the pseudonormal decides
};

bool in_box(glm::vec3 p, float low, float high) {
  return glm::all(glm::greaterThan(p, glm::vec3(low))) && glm::all(glm::lessThan(p, glm::vec3(high)));
}

std::vector<Made> made_meshes() {
  const auto both = [](TriangleMesh a, const TriangleMesh& b) {
    append(a, b);
    return a;
  };
  const auto box = [](float low, float high) { return cube(glm::vec3(low), glm::vec3(high)); };
  const TriangleMesh neighbour =
      cube({1, 1, -1}, {2, 2, 1});  // shares the edge x = y = 1 with the cube from −1 to 1
  return {
      {"cube", box(-1, 1), [](glm::vec3 p) { return in_box(p, -1, 1); }},
      {"inside_out", test::turned(box(-1, 1)), [](glm::vec3 p) { return in_box(p, -1, 1); }},
      {"sphere", test::sphere({0.1F, 0, 0}, 1.7F, 3), {}},
      {"torus", test::torus(1.5, 0.4, 40, 16), {}},
      {"cavity", both(box(-2, 2), test::turned(box(-1, 1))),
       [](glm::vec3 p) { return in_box(p, -2, 2) && !in_box(p, -1, 1); }},
      {"island_in_cavity", both(both(box(-2, 2), test::turned(box(-1, 1))), box(-0.5, 0.5)),
       [](glm::vec3 p) { return in_box(p, -2, 2) && (!in_box(p, -1, 1) || in_box(p, -0.5, 0.5)); }},
      {"nested_solid", both(box(-2, 2), box(-1, 1)), [](glm::vec3 p) { return in_box(p, -2, 2); }},
      {"overlapping", both(box(-2, 0.5), box(-0.3F, 1.5)),
       [](glm::vec3 p) { return in_box(p, -2, 0.5) || in_box(p, -0.3F, 1.5); }},
      {"shared_edge", both(box(-1, 1), neighbour),
       [](glm::vec3 p) {
         return in_box(p, -1, 1) || (p.x > 1 && p.y > 1 && p.x < 2 && p.y < 2 && p.z > -1 && p.z < 1);
       }},
      {"sliver", cube({-1.5, -1e-4F, -1.3F}, {1.5, 1e-4F, 1.3F}), {}},
  };
}

class MadeMesh : public testing::TestWithParam<Made> {};

TEST_P(MadeMesh, matches_brute_force) {
  const Folder folder;
  const Geometry geometry =
      must(Geometry::make(std::vector{placed(folder.write("m.obj", test::as_obj(GetParam().mesh)))}, 1.0F));
  const reference::MeshDistance truth(GetParam().mesh.vertices, GetParam().mesh.triangles);
  // The first puts faces and edges of the cubes exactly on cell centres, where scan lines graze; the second
  // is skew to them.
  for (const Grid& grid :
       {Grid{glm::vec3(-2.625F), 0.25F, glm::ivec3(21)}, Grid{{-2.5F, -2.41F, -2.6F}, 0.23F, {22, 21, 23}}}) {
    const DistanceField field = field_of(geometry, grid);
    expect_matches(field, truth, GetParam().inside, 1);
    for_each_cell(grid, [&](std::size_t index, glm::vec3 center) {
      ASSERT_NEAR(geometry.signed_distance(center), field.distance[index], 1e-6F);
      if (std::abs(field.distance[index]) > 1e-5F) {
        ASSERT_EQ(geometry.contains(center), field.distance[index] < 0.0F);
      }
    });
  }
}

INSTANTIATE_TEST_SUITE_P(distance_field, MadeMesh, testing::ValuesIn(made_meshes()),
                         [](const auto& test) { return test.param.name; });

class RealMesh : public testing::TestWithParam<const char*> {};

TEST_P(RealMesh, matches_brute_force_and_pseudonormals) {
  const char* data = std::getenv("MAYFLY_DATA");
  const auto file = std::filesystem::path(data == nullptr ? "" : data) / "meshes" / GetParam();
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no " << GetParam() << " in $MAYFLY_DATA/meshes";
  }
  const MeshShape shape{file, {30, 31, 29}, {20, 30, 40}, 1.0F, 50.0F, false, {}};
  const Geometry geometry = must(Geometry::make(std::vector{PlacedShape{shape, {}}}, 1.0F));
  const TriangleMesh mesh = *make_solid(*transformed(*load_mesh(file), shape), GetParam());
  const Grid grid{glm::vec3(0.0F), 1.0F, glm::ivec3(60)};
  const DistanceField field = field_of(geometry, grid);
  expect_matches(field, reference::MeshDistance(mesh.vertices, mesh.triangles), {}, 211);
}

INSTANTIATE_TEST_SUITE_P(
    distance_field, RealMesh,
    testing::Values("bunny.off", "elephant.off", "elk.off", "knot1.off", "horse-animations.glb"),
    [](const auto& test) {
      return std::string(test.param).substr(0, std::string(test.param).find_first_of(".-"));
    });

TEST(DistanceField, has_the_same_bits_on_any_number_of_threads) {
  const Folder folder;
  const auto file = folder.write("m.obj", test::as_obj(test::torus(1.5, 0.4, 40, 16)));
  const Geometry geometry = must(Geometry::make(std::vector{placed(file)}, 1.0F));
  const Grid grid{glm::vec3(-2.5F), 0.17F, {31, 30, 29}};
  const std::vector<float> one = field_of(geometry, grid, 1).distance;
  for (const int threads : {0, 2, 3, 8}) {
    EXPECT_EQ(field_of(geometry, grid, threads).distance, one) << threads << " threads";
  }
}

TEST(DistanceField, two_meshes_are_a_union) {
  const Folder folder;
  const auto file = folder.write("m.obj", test::as_obj(cube(glm::vec3(-1), glm::vec3(1))));
  const std::vector<PlacedShape> shapes{placed(file),
                                        {MeshShape{file, {0.7F, 0.6F, 0.1F}, {}, 1.0F, {}, false, {}}, {}}};
  const Geometry geometry = must(Geometry::make(shapes, 1.0F));
  const BoxShape a{{glm::vec3(-1), glm::vec3(1)}};
  const BoxShape b{{glm::vec3(-0.3F, -0.4F, -0.9F), glm::vec3(1.7F, 1.6F, 1.1F)}};
  const Geometry boxes = must(Geometry::make(std::vector<PlacedShape>{{a, {}}, {b, {}}}, 1.0F));
  const Grid grid{glm::vec3(-2.0F), 0.21F, glm::ivec3(20)};
  const DistanceField field = field_of(geometry, grid);
  for_each_cell(grid, [&](std::size_t index, glm::vec3 center) {
    ASSERT_NEAR(field.distance[index], boxes.signed_distance(center), 1e-5F);
  });
}

TEST(DistanceField, without_obstacles_is_far_everywhere) {
  const DistanceField field = field_of(must(Geometry::make({}, 1.0F)), Grid{{}, 1.0F, {3, 1, 2}});
  EXPECT_EQ(field.distance, std::vector<float>(6, kNoObstacle));
}

TEST(DistanceField, refuses_an_empty_grid) {
  EXPECT_FALSE(build_distance_field(must(Geometry::make({}, 1.0F)), Grid{{}, 1.0F, {3, 0, 2}}, 1, {}));
}

TEST(DistanceField, its_key_tells_worlds_and_grids_apart) {
  const Geometry one = must(Geometry::make(std::vector<PlacedShape>{{SphereShape{{}, 1.0F}, {}}}, 1.0F));
  const Geometry other = must(Geometry::make(std::vector<PlacedShape>{{SphereShape{{}, 1.1F}, {}}}, 1.0F));
  const Grid grid{{}, 1.0F, {3, 1, 2}};
  EXPECT_EQ(distance_key(one, grid), distance_key(one, grid));
  EXPECT_NE(distance_key(one, grid), distance_key(other, grid));
  EXPECT_NE(distance_key(one, grid), distance_key(one, Grid{{}, 1.0F, {3, 2, 1}}));
  EXPECT_NE(distance_key(one, grid), distance_key(one, Grid{{}, 1.5F, {3, 1, 2}}));
}

}  // namespace
}  // namespace mayfly::fields
