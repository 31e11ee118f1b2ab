#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "record/path_plot.hpp"
#include "record/plot_drawing.hpp"
#include "tests/unit/record/frames.hpp"

namespace mayfly::record {
namespace {

Scenario scenario_with(std::vector<fields::Shape> obstacles) {
  Scenario scenario;
  scenario.world.bounds = {{0, 0, 0}, {20, 40, 10}};
  for (fields::Shape& shape : obstacles) {
    scenario.world.obstacles.push_back({std::move(shape), {}});
  }
  scenario.world.goals.push_back({"exit", fields::SphereShape{{10, 35, 5}, 3}, {}});
  SwarmSpec swarm;
  swarm.start = fields::BoxShape{{{2, 2, 2}, {8, 8, 8}}};
  scenario.swarms.push_back(swarm);
  return scenario;
}

int width_of(const std::string& png) {
  const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(png.at(i))); };
  return byte(18) * 256 + byte(19);
}

TEST(Plot, DrawsNobodySomebodyAndNonsense) {
  for (const std::size_t agents : {0U, 1U, 3U}) {
    PathSampler paths(agents);
    test::Frames frames(agents);
    for (std::uint64_t tick = 0; tick < 3; ++tick) {
      for (std::size_t a = 0; a < agents; ++a) {
        frames.numbers[1][a] = a == 1 ? std::numeric_limits<float>::quiet_NaN() : a == 2 ? 1e30F : 3.0F;
      }
      paths.on_tick(frames.at(tick));
    }
    const auto png = draw_path_plot(scenario_with({}), Summary{}, paths);
    ASSERT_TRUE(png);
    EXPECT_THAT(*png, ::testing::StartsWith("\x89PNG"));
    EXPECT_EQ(width_of(*png), 1600);
  }
}

TEST(Plot, AMeshThatIsGoneIsAnError) {
  fields::MeshShape mesh;
  mesh.file = "/nowhere/mesh.obj";
  EXPECT_FALSE(draw_path_plot(scenario_with({mesh}), Summary{}, PathSampler(1)));
}

TEST(PlotLayout, ViewsShareTheirScaleAndAreNotMirrored) {
  for (const glm::vec3 size :
       {glm::vec3(60, 112, 40), glm::vec3(112, 60, 40), glm::vec3(10, 10, 10), glm::vec3(5, 5, 90)}) {
    const Layout layout = lay_out({{0, 0, 0}, size});
    EXPECT_EQ(layout.panels[0].scale, layout.panels[1].scale);
    for (const Panel& panel : layout.panels) {
      glm::vec3 right(0.0F), up(0.0F), toward(0.0F);
      right[panel.view.right] = 1.0F;
      up[panel.view.up] = panel.view.up_sign;
      toward[panel.view.toward] = panel.view.toward_sign;
      EXPECT_EQ(glm::cross(right, up), toward);
      EXPECT_LE(panel.area.x + panel.area.width, layout.width);
      EXPECT_LE(panel.area.y + panel.area.height, layout.height);
    }
  }
}

TEST(PlotRelief, TheNearestSolidHidesTheOthersAndNothingIsTransparent) {
  const Box bounds{{0, 0, 0}, {20, 10, 10}};
  const std::vector<ObstacleSpec> obstacles{{fields::BoxShape{{{5, 2, 0}, {15, 8, 5}}}, {}}};
  const auto triangles = triangles_of(obstacles, bounds).value();
  EXPECT_EQ(triangles.size(), 12U);
  const Panel panel = lay_out(bounds).panels[0];
  const Relief relief = draw_relief(triangles, panel);
  const auto alpha_at = [&](glm::vec3 world) {
    const auto at = (panel.at(world) - glm::dvec2(panel.area.x, panel.area.y)) * 2.0;
    return relief.pixels[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(relief.width) +
                         static_cast<std::size_t>(at.x)] >>
           24U;
  };
  EXPECT_EQ(alpha_at({10, 5, 0}), 255U);
  EXPECT_EQ(alpha_at({5.5F, 2.5F, 0}), 255U);
  EXPECT_EQ(alpha_at({4.5F, 5, 0}), 0U);
  EXPECT_EQ(alpha_at({10, 8.5F, 0}), 0U);
}

TEST(PlotSolids, AHalfSpaceEndsAtTheBounds) {
  const Box bounds{{0, 0, 0}, {10, 10, 10}};
  const std::vector<ObstacleSpec> floor{{fields::HalfSpaceShape{{0, 0, 1}, 2.0F}, {}}};
  float top = 0.0F;
  const auto triangles = triangles_of(floor, bounds).value();
  for (const Triangle& triangle : triangles) {
    for (const glm::vec3& p : triangle) {
      EXPECT_GE(p.z, 0.0F);
      top = std::max(top, p.z);
    }
  }
  EXPECT_EQ(top, 2.0F);
}

TEST(PlotTicks, AreRoundAndCoverTheRange) {
  EXPECT_THAT(round_ticks(0.0, 112.0, 13.0, 95.0),
              ::testing::ElementsAre(0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110));
  EXPECT_THAT(round_ticks(-0.25, 0.25, 800.0, 95.0),
              ::testing::Each(::testing::AllOf(::testing::Ge(-0.25), ::testing::Le(0.25))));
}

TEST(PlotColors, LightnessGrowsWithTime) {
  const auto luminance = [](const Color& c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; };
  for (int i = 0; i < 20; ++i) {
    EXPECT_LT(luminance(time_color(i / 20.0)), luminance(time_color((i + 1) / 20.0)));
  }
}

}  // namespace
}  // namespace mayfly::record
