// Curl noise at the walls of every mesh in config/meshes, shipped or fetched: nothing of it goes through
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <random>

#include "controller/flight/swarm_models.hpp"
#include "kernels/boundary.h"
#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

std::vector<std::string> meshes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(MAYFLY_SOURCE_DIR "/config/meshes")) {
    names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The mesh, 16 m long, in the middle of 32 m of air.
Scenario with_mesh(const std::string& name) {
  Scenario scenario = hall(1);
  scenario.world.bounds = {{0, 0, 0}, {32, 32, 32}};
  scenario.world.goals[0].shape = box({1, 1, 28}, {4, 4, 31});
  scenario.swarms[0].start = box({1, 1, 1}, {3, 3, 3});
  fields::MeshShape mesh;
  mesh.file = MAYFLY_SOURCE_DIR "/config/meshes/" + name;
  mesh.position = {16, 16, 16};
  mesh.fit = 16.0F;
  scenario.world.obstacles = {{mesh, {"mesh.yaml", 4, 5}}};
  scenario.swarms[0].noise.octaves = {{0.4F, 0.25F}};
  return scenario;
}

glm::vec3 first_lane(kernels::F3 v) {
  return {v.x[0], v.y[0], v.z[0]};
}

class WallNoise : public testing::TestWithParam<std::string> {
 protected:
  WallNoise() : world_(world_of(with_mesh(GetParam()))), field_(models().swarms.at(0).field) {}

  SwarmModels models() const { return make_swarm_models(with_mesh(GetParam()), world_); }
  kernels::MfSurface surface(glm::vec3 p) const {
    return kernels::mf_surface(kernels::mf3_splat(p.x, p.y, p.z), world_.walls.data(), &field_.grid);
  }
  // Component along the wall's normal, as a share of the noise's rms speed in the open.
  double through(glm::vec3 p) const {
    const kernels::MfSurface s = surface(p);
    const kernels::MfJet jet =
        kernels::mf_potential(kernels::mf3_splat(p.x, p.y, p.z), &field_.noise, nullptr);
    const glm::vec3 v = first_lane(kernels::mf_bounded_curl(&jet, &s, field_.boundary));
    return std::fabs(glm::dot(v, glm::normalize(first_lane(s.gradient)))) / field_.noise.rms_speed;
  }
  // Points on the sampled wall φ = 0, by Newton's steps from random ones nearby.
  template <class Visit>
  int for_wall_points(int wanted, Visit visit) const {
    std::mt19937 engine(4);
    std::uniform_real_distribution<float> coordinate(6, 26);
    int found = 0;
    for (int tries = 0; tries < 400 * wanted && found < wanted; ++tries) {
      glm::vec3 p(coordinate(engine), coordinate(engine), coordinate(engine));
      if (std::fabs(surface(p).value[0]) > 1.0F) {
        continue;
      }
      for (int step = 0; step < 6; ++step) {
        const kernels::MfSurface s = surface(p);
        const glm::vec3 gradient = first_lane(s.gradient);
        p -= gradient * (s.value[0] / std::max(glm::dot(gradient, gradient), 0.05F));
      }
      if (std::fabs(surface(p).value[0]) < 1e-5F) {
        ++found;
        visit(p);
      }
    }
    return found;
  }

  World world_;
  kernels::MfField field_;
};

TEST_P(WallNoise, HasNoComponentThroughTheWallThatIsSampled) {
  double worst = 0;
  const int found = for_wall_points(2000, [&](glm::vec3 p) { worst = std::max(worst, through(p)); });
  EXPECT_EQ(found, 2000);
  std::printf("%s: worst normal component %.4f %% of the noise's rms speed\n", GetParam().c_str(),
              100 * worst);
  EXPECT_LE(worst, 0.01);
}

// Half a cell off the wall the same measure is far from nothing: it can fail.
TEST_P(WallNoise, HasOneFartherOut) {
  double mean = 0;
  const int found = for_wall_points(
      500, [&](glm::vec3 p) { mean += through(p + 0.5F * glm::normalize(first_lane(surface(p).gradient))); });
  EXPECT_GT(mean / found, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Meshes, WallNoise, testing::ValuesIn(meshes()),
                         [](const auto& mesh) { return std::filesystem::path(mesh.param).stem().string(); });

}  // namespace
}  // namespace mayfly::test
