// How long the distance field takes, by triangles and cells. Arguments, all optional: mesh files to time as
// well, each fitted into 100³ cells.
//
// Baselines on a machine of this kind (2 × Zen 3), 100³ cells, 1 k / 5 k / 70 k triangles, two threads:
// TriangleMeshDistance 0.8 / 2.3 / 8.4 s; CGAL's AABB tree, unsigned, 1.5 / 3.8 / 12.7 s.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "fields/distance_field.hpp"
#include "fields/make_grid.hpp"

namespace mayfly::fields {
namespace {

// A torus with waves on it, so that no two triangles are alike: 2·around·across triangles.
std::filesystem::path write_torus(int around, int across) {
  auto file =
      std::filesystem::temp_directory_path() / ("torus" + std::to_string(2 * around * across) + ".obj");
  std::ofstream out(file);
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * i / around;
      const double v = 2.0 * std::numbers::pi * j / across;
      const double r = 0.35 + 0.03 * std::sin(7.0 * u + 3.0 * v);
      out << "v " << (1.0 + r * std::cos(v)) * std::cos(u) << ' ' << (1.0 + r * std::cos(v)) * std::sin(u)
          << ' ' << r * std::sin(v) << '\n';
    }
  }
  const auto corner = [&](int i, int j) { return i % around * across + j % across + 1; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      out << "f " << corner(i, j) << ' ' << corner(i + 1, j) << ' ' << corner(i + 1, j + 1) << '\n';
      out << "f " << corner(i, j) << ' ' << corner(i + 1, j + 1) << ' ' << corner(i, j + 1) << '\n';
    }
  }
  return file;
}

double best_of_five_ms(const auto& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(
        best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void time(const std::string& name, const std::vector<PlacedShape>& shapes, const Box& bounds) {
  const auto start = std::chrono::steady_clock::now();
  const Result<Geometry> geometry = Geometry::make(shapes, 1.0F);
  const double made_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const Result<Grid> grid = make_grid(bounds, 1.0F);
  if (!geometry || !grid) {
    std::printf("%s: %s\n", name.c_str(), to_string(geometry ? grid.error() : geometry.error()).c_str());
    return;
  }
  std::printf("%-28s %8zu %9zu %9.1f", name.c_str(), geometry->triangle_count(), grid->size(), made_ms);
  for (const int threads : {1, 2}) {
    const double ms = best_of_five_ms([&] { (void)build_distance_field(*geometry, *grid, threads, {}); });
    std::printf(" %9.1f ms %6.1f ns/cell", ms, 1e6 * ms / static_cast<double>(grid->size()));
  }
  std::printf("\n");
}

PlacedShape fitted(const std::filesystem::path& file) {
  MeshShape mesh{file, glm::vec3(50.0F), {}, 1.0F, 80.0F, false, {}};
  return {mesh, {}};
}

int run(int argc, char** argv) {
  std::printf("%-28s %8s %9s %9s %27s %27s\n", "", "tris", "cells", "make ms", "1 thread", "2 threads");
  const std::filesystem::path block = std::filesystem::path(MAYFLY_SOURCE_DIR) / "config/meshes/block.obj";
  std::vector<PlacedShape> blocks;
  for (const float x : {15.0F, 45.0F}) {
    blocks.push_back({MeshShape{block, {x, 56.0F, 20.0F}, {}, 20.0F, {}, false, {}}, {}});
  }
  time("two blocks", blocks, Box{glm::vec3(0.0F), {60.0F, 112.0F, 40.0F}});
  const Box cube{glm::vec3(0.0F), glm::vec3(100.0F)};
  for (const auto& [around, across] : {std::pair{32, 16}, std::pair{64, 40}, std::pair{280, 125}}) {
    time("torus", {fitted(write_torus(around, across))}, cube);
  }
  for (int i = 1; i < argc; ++i) {
    time(std::filesystem::path(argv[i]).filename().string(), {fitted(argv[i])}, cube);
  }
  return 0;
}

}  // namespace
}  // namespace mayfly::fields

int main(int argc, char** argv) {
  return mayfly::fields::run(argc, argv);
}
