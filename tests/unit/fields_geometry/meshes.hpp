// Meshes and files made for a test.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fields/mesh.hpp"

namespace mayfly::fields::test {

// A folder that goes away with the test.
class Folder {
 public:
  Folder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() / ("mayfly_" + std::string(info->test_suite_name()) + "_" +
                                                      info->name() + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline void append(TriangleMesh& to, const TriangleMesh& mesh) {
  const auto first = static_cast<glm::uint>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (const glm::uvec3& t : mesh.triangles) {
    to.triangles.push_back(t + first);
  }
}

inline TriangleMesh turned(TriangleMesh mesh) {
  for (glm::uvec3& t : mesh.triangles) {
    std::swap(t.y, t.z);
  }
  return mesh;
}

inline TriangleMesh cube(glm::vec3 low, glm::vec3 high) {
  TriangleMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1U ? high.x : low.x, i & 2U ? high.y : low.y, i & 4U ? high.z : low.z);
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

// An octahedron, each triangle split in four `levels` times.
inline TriangleMesh sphere(glm::vec3 center, float radius, int levels) {
  TriangleMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<glm::uint, glm::uint>, glm::uint> middles;
    const auto middle = [&](glm::uint a, glm::uint b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<glm::uint>(mesh.vertices.size()));
      if (is_new) {
        mesh.vertices.push_back(glm::normalize(mesh.vertices[a] + mesh.vertices[b]));
      }
      return found->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::uint xy = middle(t.x, t.y);
      const glm::uint yz = middle(t.y, t.z);
      const glm::uint zx = middle(t.z, t.x);
      finer.insert(finer.end(), {{t.x, xy, zx}, {xy, t.y, yz}, {zx, yz, t.z}, {xy, yz, zx}});
    }
    mesh.triangles = std::move(finer);
  }
  for (glm::vec3& v : mesh.vertices) {
    v = center + radius * v;
  }
  return mesh;
}

// Vertex (i, j) of a rectangle of quads whose far sides are joined to the near ones; `place` says where it
// lies.
inline TriangleMesh wrapped(glm::uint around, glm::uint across, const auto& place, const auto& join) {
  TriangleMesh mesh;
  for (glm::uint i = 0; i < around; ++i) {
    for (glm::uint j = 0; j < across; ++j) {
      mesh.vertices.push_back(place(static_cast<double>(i) / around, static_cast<double>(j) / across));
    }
  }
  for (glm::uint i = 0; i < around; ++i) {
    for (glm::uint j = 0; j < across; ++j) {
      const glm::uint a = join(i, j);
      const glm::uint b = join(i + 1, j);
      const glm::uint c = join(i + 1, j + 1);
      const glm::uint d = join(i, j + 1);
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    }
  }
  return mesh;
}

inline TriangleMesh torus(double ring, double tube, glm::uint around, glm::uint across) {
  return wrapped(
      around, across,
      [&](double s, double t) {
        const double u = 2.0 * std::numbers::pi * s;
        const double v = 2.0 * std::numbers::pi * t;
        const double out = ring + tube * std::cos(v);
        return glm::vec3(out * std::cos(u), out * std::sin(u), tube * std::sin(v));
      },
      [&](glm::uint i, glm::uint j) { return i % around * across + j % across; });
}

// Closed, and one-sided: its far end is joined the wrong way round.
inline TriangleMesh klein_bottle(glm::uint around, glm::uint across) {
  return wrapped(
      around, across,
      [](double s, double t) {
        const double u = 2.0 * std::numbers::pi * s;
        const double v = 2.0 * std::numbers::pi * t;
        const double out = 3.0 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
        return glm::vec3(out * std::cos(u), out * std::sin(u),
                         std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v));
      },
      [&](glm::uint i, glm::uint j) {
        return i < around ? i * across + j % across : (across - j % across) % across;
      });
}

inline std::string as_obj(const TriangleMesh& mesh) {
  std::string text;
  for (const glm::vec3& v : mesh.vertices) {
    char line[100];
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", static_cast<double>(v.x), static_cast<double>(v.y),
                  static_cast<double>(v.z));
    text += line;
  }
  for (const glm::uvec3& t : mesh.triangles) {
    text +=
        "f " + std::to_string(t.x + 1) + " " + std::to_string(t.y + 1) + " " + std::to_string(t.z + 1) + "\n";
  }
  return text;
}

}  // namespace mayfly::fields::test
