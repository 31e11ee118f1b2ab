#include "kernels/boundary.h"

#include <gtest/gtest.h>

#include "kernels/field.h"
#include "tests/reference/walls_reference.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly::kernels {
namespace {

using namespace kernels;
using reference::Vec;
using test::all_lanes;
using test::lane;
using test::Points;

const Grid kGrid{{-8.0F, -8.0F, -8.0F}, 0.5F, {32, 32, 32}};
constexpr float kD0 = 1.0F;
constexpr std::uint32_t kSeed = 21;

MfGrid grid() {
  return {kGrid.origin.x, kGrid.origin.y, kGrid.origin.z, kGrid.cell, 1 / kGrid.cell,
          kGrid.cells.x,  kGrid.cells.y,  kGrid.cells.z,  0};
}

// A ball of radius 4 at the origin.
std::vector<float> ball() {
  std::vector<float> table(kGrid.size());
  for (int k = 0; k < kGrid.cells.z; ++k) {
    for (int j = 0; j < kGrid.cells.y; ++j) {
      for (int i = 0; i < kGrid.cells.x; ++i) {
        const glm::vec3 c = kGrid.center(i, j, k);
        table[kGrid.index(i, j, k)] = std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z) - 4.0F;
      }
    }
  }
  return table;
}

Vec bounded(const std::vector<float>& table, Vec x) {
  const MfGrid g = grid();
  const MfNoise noise = test::noise_of(kSeed, 1.0F, 0.5F);
  const MfJet p = mf_potential(all_lanes(x), &noise, nullptr);
  const MfSurface s = mf_surface(all_lanes(x), table.data(), &g);
  return lane(mf_bounded_curl(&p, &s, kD0));
}

// A point at the given height above the ball.
Vec above_ball(Points& points, double height) {
  const Vec direction = points.next();
  return direction * ((4 + height) / reference::norm(direction));
}

TEST(BoundedCurl, EqualsTheReferenceInDouble) {
  const auto table = ball();
  const reference::Slots slots = reference::hashed_slots(kSeed);
  const auto phi = [&](Vec x) { return reference::spline(table, kGrid, x); };
  const auto p = [&](Vec x) { return reference::potential(x, 1, 0.5, slots); };
  const auto n = [&](Vec x) { return reference::bounded_potential(phi, p, x, kD0); };
  Points points(1);
  for (int tested = 0; tested < 60;) {
    Vec x = above_ball(points, 0.05 + 0.9 * tested / 60);
    for (double& c : x) {
      c = std::round(c * 4096) / 4096;
    }
    const bool smooth_here = std::all_of(x.begin(), x.end(), [](double c) {
      const double t = 2 * c - std::floor(2 * c);
      return t > 0.02 && t < 0.98;
    });
    if (!smooth_here) {
      continue;
    }
    ++tested;
    EXPECT_LT(reference::norm(bounded(table, x) - reference::curl(n, x, 1e-3)), 5e-4);
  }
}

TEST(BoundedCurl, HasNoComponentThroughTheWall) {
  const auto table = ball();
  const MfGrid g = grid();
  Points points(1);
  double worst = 0;
  for (int n = 0; n < 500; ++n) {
    // Walk onto the sampled surface φ = 0, which is where α vanishes.
    Vec x = above_ball(points, 0);
    MfSurface s{};
    for (int step = 0; step < 4; ++step) {
      s = mf_surface(all_lanes(x), table.data(), &g);
      x = x - lane(s.gradient) * (s.value[0] / reference::dot(lane(s.gradient), lane(s.gradient)));
    }
    const Vec normal = lane(s.gradient) * (1 / reference::norm(lane(s.gradient)));
    worst = std::max(worst, std::fabs(reference::dot(bounded(table, x), normal)));
  }
  EXPECT_LT(worst, 0.01 * 0.86);  // 1 % of the free-stream rms speed 1.718·gain/scale
}

TEST(BoundedCurl, IsTheFreeCurlFromD0Outwards) {
  const auto table = ball();
  const MfNoise noise = test::noise_of(kSeed, 1.0F, 0.5F);
  Points points(1);
  for (int n = 0; n < 100; ++n) {
    const Vec x = above_ball(points, 1.3);
    EXPECT_LT(reference::norm(bounded(table, x) - lane(mf_curl_noise(all_lanes(x), &noise, nullptr))), 1e-6);
  }
}

TEST(BoundedCurl, HasNoDivergenceBesideTheWall) {
  const auto table = ball();
  const auto v = [&](Vec x) { return bounded(table, x); };
  Points points(1, 4);
  double worst = 0;
  for (int tested = 0; tested < 100;) {
    Vec x = above_ball(points, 0.2 + 0.006 * tested);
    for (double& c : x) {
      c = std::round(c * 4096) / 4096;
    }
    const bool one_piece = std::all_of(x.begin(), x.end(), [](double c) {
      const double t = 2 * c - std::floor(2 * c);
      return t > 0.07 && t < 0.93;
    });
    const auto [divergence, gradient] = reference::divergence_and_gradient(v, x, 1.0 / 128);
    if (!one_piece || gradient < 0.5) {
      continue;
    }
    ++tested;
    worst = std::max(worst, std::fabs(divergence) / gradient);
  }
  std::printf("worst |div|/|grad| beside a wall: %.2e\n", worst);
  EXPECT_LE(worst, 2e-4);
}

TEST(WallGuard, LetsNothingInFasterThanTheClearanceAllows) {
  const auto table = ball();
  MfField field{};
  field.grid = grid();
  field.radius = 0.1F;
  field.approach_rate = 2.0F;
  field.wall_reach = 3.0F;
  field.has_walls = 1;
  field.low_x = field.low_y = field.low_z = -100.0F;
  field.high_x = field.high_y = field.high_z = 100.0F;
  Points points(1);
  for (int n = 0; n < 500; ++n) {
    const double height = -0.3 + 0.004 * n;
    const Vec x = above_ball(points, height);
    const Vec v = points.next() * 6;
    const MfSurface s = mf_surface(all_lanes(x), table.data(), &field.grid);
    const Vec normal = lane(mf3_unit(s.gradient));
    const Vec guarded = lane(mf_field_guard(all_lanes(x), all_lanes(v), &field, table.data()));
    const double slowest = -(s.value[0] - 0.1) * 2.0;
    EXPECT_GE(reference::dot(guarded, normal), slowest - 1e-5);
    if (reference::dot(v, normal) > slowest) {
      EXPECT_LT(reference::norm(guarded - v), 1e-6) << "touched a harmless velocity";
    } else {
      const Vec change = guarded - v;
      EXPECT_LT(reference::norm(change - normal * reference::dot(change, normal)), 1e-5)
          << "changed more than it had to";
    }
  }
}

TEST(BoundsGuard, LetsAgentsSlideAlongTheWorldsBounds) {
  MfField field{};
  field.approach_rate = 2.0F;
  field.low_x = field.low_y = field.low_z = 0.0F;
  field.high_x = field.high_y = field.high_z = 10.0F;
  const Vec v = lane(mf_guard_bounds(all_lanes({3, -3, 1}), all_lanes({5, 0, 9.9}), &field));
  EXPECT_NEAR(v[0], 3, 1e-6) << "far from every bound";
  EXPECT_NEAR(v[1], 0, 1e-6) << "at the bound";
  EXPECT_NEAR(v[2], 0.2, 1e-5) << "0.1 m from it, at 2/s";
  const Vec back = lane(mf_guard_bounds(all_lanes({0, 0, 0}), all_lanes({-1, 5, 11}), &field));
  EXPECT_NEAR(back[0], 2, 1e-6) << "outside, it comes back";
  EXPECT_NEAR(back[2], -2, 1e-6);
}

}  // namespace
}  // namespace mayfly::kernels
