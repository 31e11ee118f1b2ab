#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "tests/unit/fields_geometry/meshes.hpp"

namespace mayfly::fields {
namespace {

using test::Folder;
using testing::HasSubstr;

const TriangleMesh kCube = test::cube(glm::vec3(-1), glm::vec3(1));

template <class T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string coordinates(const glm::vec3& v) {
  return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
}

std::string faces(const std::string& before) {
  std::string text;
  for (const glm::uvec3& t : kCube.triangles) {
    text += before + std::to_string(t.x) + " " + std::to_string(t.y) + " " + std::to_string(t.z) + "\n";
  }
  return text;
}

std::string vertices() {
  std::string text;
  for (const glm::vec3& v : kCube.vertices) {
    text += coordinates(v);
  }
  return text;
}

std::string off() {
  return "OFF\n# a cube\n8 12 0\n\n" + vertices() + faces("3 ");
}

std::string ascii_stl() {
  std::string text = "solid cube\n";
  for (const glm::uvec3& t : kCube.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (int corner = 0; corner < 3; ++corner) {
      text += "vertex " + coordinates(kCube.vertices[t[corner]]);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid cube\n";
}

std::string binary_stl() {
  std::string bytes(80, ' ');
  put(bytes, std::uint32_t{12});
  for (const glm::uvec3& t : kCube.triangles) {
    put(bytes, glm::vec3(0.0F));
    for (int corner = 0; corner < 3; ++corner) {
      put(bytes, kCube.vertices[t[corner]]);
    }
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string ply_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment cube\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ascii_ply() {
  return ply_header("ascii") + vertices() + faces("3 ");
}

std::string binary_ply() {
  std::string bytes = ply_header("binary_little_endian");
  for (const glm::vec3& v : kCube.vertices) {
    put(bytes, v);
  }
  for (const glm::uvec3& t : kCube.triangles) {
    put(bytes, std::uint8_t{3});
    put(bytes, t);
  }
  return bytes;
}

std::string gltf_buffer() {
  std::string bytes;
  for (const glm::vec3& v : kCube.vertices) {
    put(bytes, v);
  }
  for (const glm::uvec3& t : kCube.triangles) {
    put(bytes, glm::vec<3, std::uint16_t>(t));
  }
  return bytes;  // 96 + 72
}

// The cube, moved by its node to x = 5, and mirrored, so that its winding must be turned back.
std::string gltf_json(
    const std::string& uri,
    const std::string& nodes = R"([{"children":[1],"translation":[5,0,0]},{"mesh":0,"scale":[-1,1,1]}])") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]},)"
         R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],"bufferViews":[)"
         R"({"buffer":0,"byteOffset":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],)"
         R"("buffers":[{)" +
         uri + R"("byteLength":168}]})";
}

std::string glb() {
  std::string json = gltf_json("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = gltf_buffer();
  std::string bytes = "glTF";
  put(bytes, std::uint32_t{2});
  put(bytes, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
  put(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  put(bytes, static_cast<std::uint32_t>(buffer.size()));
  bytes += std::string("BIN\0", 4) + buffer;
  return bytes;
}

struct Sample {
  std::string name;
  std::string bytes;
  // The first bytes whose loss cannot be told from the file alone: OBJ has no counts.
  bool counted = true;
};

std::vector<Sample> samples() {
  return {{"cube.off", off()},        {"cube.OBJ", test::as_obj(kCube), false},
          {"ascii.stl", ascii_stl()}, {"binary.stl", binary_stl()},
          {"ascii.ply", ascii_ply()}, {"binary.ply", binary_ply()},
          {"cube.glb", glb()}};
}

class MeshFile : public testing::TestWithParam<Sample> {};

TEST_P(MeshFile, is_read_and_welded) {
  const Folder folder;
  const Result<TriangleMesh> mesh = load_mesh(folder.write(GetParam().name, GetParam().bytes));
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  EXPECT_EQ(mesh->vertices.size(), 8U);
  EXPECT_EQ(mesh->triangles.size(), 12U);
  EXPECT_TRUE(check_closed(*mesh).closed());
  EXPECT_EQ(check_closed(*mesh).inside_out, 0U);
}

// Cut anywhere up to the last few bytes (a final line break, or the last digits of a number, are no loss).
TEST_P(MeshFile, cut_short_is_refused_and_named) {
  const Folder folder;
  const auto& [name, bytes, counted] = GetParam();
  for (std::size_t size = 0; size + 13 < bytes.size(); size += 1 + bytes.size() / 97) {
    const Result<TriangleMesh> mesh = load_mesh(folder.write(name, bytes.substr(0, size)));
    if (mesh) {
      EXPECT_FALSE(counted) << "cut at " << size << " of " << bytes.size();
      EXPECT_FALSE(make_solid(*mesh, name)) << "cut at " << size;
    } else {
      EXPECT_THAT(to_string(mesh.error()), HasSubstr("mesh '" + name + "'"));
      EXPECT_FALSE(mesh.error().found.empty());
      EXPECT_FALSE(mesh.error().wanted.empty());
    }
  }
}

TEST_P(MeshFile, garbage_never_crashes) {
  const Folder folder;
  const auto& [name, bytes, counted] = GetParam();
  std::uint32_t state = 1;
  const auto random = [&] { return state = state * 1664525U + 1013904223U; };
  for (int round = 0; round < 150; ++round) {
    std::string damaged = bytes;
    for (int i = 0; i < 1 + round % 4; ++i) {
      damaged[(random() >> 8) % damaged.size()] = static_cast<char>(random() >> 24);
    }
    const Result<TriangleMesh> mesh = load_mesh(folder.write(name, damaged));
    if (mesh) {
      for (const glm::uvec3& t : mesh->triangles) {
        ASSERT_TRUE(t.x < mesh->vertices.size() && t.y < mesh->vertices.size() &&
                    t.z < mesh->vertices.size());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(formats, MeshFile, testing::ValuesIn(samples()), [](const auto& test) {
  std::string name = test.param.name;
  name[name.find('.')] = '_';
  return name;
});

TEST(Gltf, its_nodes_place_the_mesh_and_its_buffer_may_lie_beside_it) {
  const Folder folder;
  folder.write("cube.bin", gltf_buffer());
  const Result<TriangleMesh> mesh = load_mesh(folder.write("a.gltf", gltf_json(R"("uri":"cube.bin",)")));
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  for (const glm::vec3& v : mesh->vertices) {
    EXPECT_FLOAT_EQ(std::abs(v.x - 5.0F), 1.0F);
  }
  EXPECT_EQ(check_closed(*mesh).inside_out, 0U);
}

struct Bad {
  std::string name, bytes, message;
};

TEST(MeshFiles, bad_ones_are_refused_with_a_reason) {
  const std::string cycle = R"([{"children":[1]},{"children":[0],"mesh":0}])";
  const std::vector<Bad> all{
      {"a.fbx", "x", "ending"},
      {"a", "x", "ending"},
      {"empty.obj", "", "empty"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no triangles"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 nan\nf 1 2 3\n", "line 3"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "vertex 4"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "line 4"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 1\n", "without extent"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "'3 0 1 3' in line 6"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", "line 4"},
      {"a.off", "OFF\n99999999999999999999 1 0\n", "counts"},
      {"a.off", "OFF\n18446744073709551615 1 0\n", "too large"},
      {"a.off", "<html>", "not what its ending says"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex -3\n", "header"},
      {"a.glb", "glTF", "truncated"},
      {"a.gltf", "[" + std::string(100000, '['), "nested"},
      {"a.gltf", "{}", "no mesh"},
      {"a.gltf", gltf_json(R"("uri":"../cube.bin",)"), "not a .bin file beside"},
      {"a.gltf", gltf_json(R"("uri":"/etc/passwd",)"), "not a .bin file beside"},
      {"a.gltf", gltf_json(R"("uri":"missing.bin",)"), "buffer"},
      {"a.gltf", gltf_json(R"("uri":"short.bin",)"), "a buffer of 5 bytes that should have 168"},
      {"a.gltf", gltf_json(R"("uri":"short.bin",)", cycle), ""},
  };
  const Folder folder;
  folder.write("short.bin", "12345");
  for (const Bad& bad : all) {
    const Result<TriangleMesh> mesh = load_mesh(folder.write(bad.name, bad.bytes));
    ASSERT_FALSE(mesh) << bad.message;
    EXPECT_THAT(to_string(mesh.error()), HasSubstr("'" + bad.name + "'"));
    EXPECT_THAT(to_string(mesh.error()), HasSubstr(bad.message));
  }
  EXPECT_FALSE(load_mesh(folder.path() / "missing.obj"));
  std::filesystem::create_directory(folder.path() / "folder.obj");
  EXPECT_FALSE(load_mesh(folder.path() / "folder.obj"));
}

TEST(Gltf, nodes_in_a_circle_are_refused) {
  const Folder folder;
  folder.write("cube.bin", gltf_buffer());
  const std::string cycle = R"([{"children":[1]},{"children":[0],"mesh":0}])";
  EXPECT_FALSE(load_mesh(folder.write("a.gltf", gltf_json(R"("uri":"cube.bin",)", cycle))));
}

// An L-shaped prism: its two ends are polygons that no fan from one corner covers.
TEST(MeshFiles, polygons_that_are_not_convex_keep_their_shape) {
  const std::vector<std::pair<int, int>> outline{{3, 1}, {1, 1}, {1, 3}, {0, 3}, {0, 0}, {3, 0}};
  std::string text;
  for (const int z : {0, 1}) {
    for (const auto& [x, y] : outline) {
      text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    }
  }
  text += "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
  for (int i = 0; i < 6; ++i) {
    const int next = (i + 1) % 6;
    text += "f " + std::to_string(i + 1) + " " + std::to_string(next + 1) + " " + std::to_string(next + 7) +
            " " + std::to_string(i + 7) + "\n";
  }
  const Folder folder;
  const Result<TriangleMesh> mesh = load_mesh(folder.write("l.obj", text));
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  EXPECT_TRUE(check_closed(*mesh).closed());
  double six_volumes = 0.0;
  double area = 0.0;
  for (const glm::uvec3& t : mesh->triangles) {
    const glm::dvec3 a(mesh->vertices[t.x]);
    const glm::dvec3 b(mesh->vertices[t.y]);
    const glm::dvec3 c(mesh->vertices[t.z]);
    six_volumes += glm::dot(a, glm::cross(b, c));
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  EXPECT_NEAR(six_volumes / 6.0, 5.0, 1e-9);
  EXPECT_NEAR(area, 22.0, 1e-9);
}

TEST(MeshFiles, the_projects_block_is_a_unit_cube) {
  const Result<TriangleMesh> mesh =
      load_mesh(std::filesystem::path(MAYFLY_SOURCE_DIR) / "config/meshes/block.obj");
  ASSERT_TRUE(mesh) << to_string(mesh.error());
  EXPECT_EQ(mesh->triangles.size(), 12U);
  EXPECT_TRUE(check_closed(*mesh).closed());
  EXPECT_EQ(check_closed(*mesh).inside_out, 0U);
  for (const glm::vec3& v : mesh->vertices) {
    EXPECT_EQ(glm::abs(v), glm::vec3(0.5F));
  }
}

}  // namespace
}  // namespace mayfly::fields
