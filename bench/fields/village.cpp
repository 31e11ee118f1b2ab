#include "bench/fields/village.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <glm/vec3.hpp>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include "controller/scenario/load.hpp"

namespace mayfly::bench {
namespace {

const std::filesystem::path kSource = MAYFLY_SOURCE_DIR;

struct Triangles {
  std::vector<glm::vec3> corners;
  std::vector<std::array<std::size_t, 3>> faces;
};

// Enough of OBJ for the meshes of config/meshes that are triangles.
Triangles read_triangles(const std::filesystem::path& file) {
  Triangles mesh;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      glm::vec3& v = mesh.corners.emplace_back();
      words >> v.x >> v.y >> v.z;
    } else if (kind == "f") {
      auto& face = mesh.faces.emplace_back();
      words >> face[0] >> face[1] >> face[2];
    }
  }
  return mesh;
}

// The same surface with four triangles for each.
Triangles subdivide(const Triangles& mesh) {
  Triangles finer{mesh.corners, {}};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), finer.corners.size() + 1);
    if (is_new) {
      finer.corners.push_back(0.5F * (mesh.corners[a - 1] + mesh.corners[b - 1]));
    }
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const std::size_t ab = middle(a, b);
    const std::size_t bc = middle(b, c);
    const std::size_t ca = middle(c, a);
    finer.faces.insert(finer.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return finer;
}

std::filesystem::path finer_mesh(const std::filesystem::path& file, int subdivisions) {
  Triangles mesh = read_triangles(file);
  for (int n = 0; n < subdivisions; ++n) {
    mesh = subdivide(mesh);
  }
  auto finer = std::filesystem::temp_directory_path() /
               (file.stem().string() + "_" + std::to_string(subdivisions) + ".obj");
  std::ofstream out(finer);
  for (const glm::vec3& v : mesh.corners) {
    out << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
  }
  for (const auto& f : mesh.faces) {
    out << "f " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  }
  return finer;
}

void add_finer_meshes(const Scenario& village, int subdivisions, std::vector<Override>& overrides) {
  for (std::size_t o = 0; o < village.world.obstacles.size(); ++o) {
    if (const auto* mesh = std::get_if<fields::MeshShape>(&village.world.obstacles[o].shape)) {
      overrides.push_back(
          {"world.obstacles." + std::to_string(o) + ".mesh", finer_mesh(mesh->file, subdivisions).string()});
    }
  }
}

// m: at which Wang14's 0.68 % of the agents are too near to another, were all strewn over the world at
// random.
double crowded_separation(std::size_t agents) {
  constexpr double kVolume = 118.0 * 53.0 * 48.0;  // m³
  return std::cbrt(0.0068 * kVolume / (4.0 / 3.0 * std::numbers::pi * static_cast<double>(agents)));
}

}  // namespace

tl::expected<Village, std::vector<Error>> make_village(const VillagePlan& plan) {
  const auto file = kSource / "config/scenarios/locusts.yaml";
  std::vector<Override> overrides{{"swarms.locusts.count", std::to_string(plan.agents)},
                                  {"world.cell", std::to_string(plan.cell)}};
  if (plan.everywhere) {
    overrides.push_back({"swarms.locusts.start", "{box: {min: [1, 1, 1], max: [119, 54, 49]}}"});
    overrides.push_back(
        {"swarms.locusts.limits.separation", std::to_string(crowded_separation(plan.agents))});
  }
  if (plan.subdivisions > 0) {
    auto village = load_scenario(file);
    if (!village) {
      return tl::unexpected(std::move(village.error()));
    }
    add_finer_meshes(*village, plan.subdivisions, overrides);
  }
  auto scenario = load_scenario(file, overrides);
  if (!scenario) {
    return tl::unexpected(std::move(scenario.error()));
  }
  auto ready = prepare(*scenario, {.threads = plan.threads, .cache = fields::FieldCache::none()});
  if (!ready) {
    return tl::unexpected(std::move(ready.error()));
  }
  return Village{std::move(*scenario), std::move(*ready)};
}

Flock flock_of(const Village& village) {
  return {.swarms = village.ready->models.swarms,
          .places = village.ready->places,
          .period_s = 1.0F / village.scenario.control.rate};
}

}  // namespace mayfly::bench
