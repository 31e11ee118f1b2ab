#include "kernels/fence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/reference/walls_reference.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly::kernels {
namespace {

using reference::Vec;
using test::all_lanes;
using test::lane;
using test::Points;

constexpr float kD0 = 1.0F;
constexpr std::uint32_t kSeed = 21;
const MfFence kBox{MF_FENCE_BOX, 0, 0, 0, 4.0F, 3.0F, 2.0F};
const MfFence kSphere{MF_FENCE_SPHERE, 0, 0, 0, 4.0F, 4.0F, 4.0F};

Vec fenced(const MfFence& fence, Vec x) {
  const MfNoise noise = test::noise_of(kSeed, 1.0F, 0.5F);
  const MfJet p = mf_potential(all_lanes(x), &noise, nullptr);
  return lane(mf_fenced_curl(&p, all_lanes(x), &fence, kD0));
}

Vec free_potential(Vec x) {
  return reference::potential(x, 1, 0.5, reference::hashed_slots(kSeed));
}

// Wang14 Eq. 2 for the six planes of the box, one after the other: each takes the tangential parts away.
Vec box_potential(Vec x) {
  Vec p = free_potential(x);
  const Vec half{4, 3, 2};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double alpha = reference::ramp((half[axis] - std::fabs(x[axis])) / static_cast<double>(kD0));
    for (std::size_t other = 0; other < 3; ++other) {
      p[other] *= other == axis ? 1.0 : alpha;
    }
  }
  return p;
}

Vec sphere_potential(Vec x) {
  const auto phi = [](Vec y) { return 4 - reference::norm(y); };
  return reference::bounded_potential(phi, free_potential, x, static_cast<double>(kD0));
}

Vec in_box(Points& points) {
  const Vec u = points.next();
  return {3.99 * u[0], 2.99 * u[1], 1.99 * u[2]};
}

TEST(Fence, TellsTheDepth) {
  const auto depth = [](Vec x, const MfFence& fence) { return mf_fence_depth(all_lanes(x), &fence)[0]; };
  EXPECT_FLOAT_EQ(depth({0, 0, 0}, kBox), 2);
  EXPECT_FLOAT_EQ(depth({-3.5, 0, 0}, kBox), 0.5);
  EXPECT_FLOAT_EQ(depth({0, 3.5, 0}, kBox), -0.5);
  EXPECT_FLOAT_EQ(depth({0, 0, 0}, kSphere), 4);
  EXPECT_FLOAT_EQ(depth({0, -3, 0}, kSphere), 1);
  EXPECT_FLOAT_EQ(depth({0, 0, 5}, kSphere), -1);
}

TEST(Fence, EqualsTheReferenceInDouble) {
  Points points(1, 3);
  int compared = 0;
  for (int tried = 0; tried < 400; ++tried) {
    Vec x = in_box(points);
    for (double& c : x) {
      c = std::round(c * 4096) / 4096;
    }
    // Second differences must not reach over a plane where the ramp's third derivative jumps.
    EXPECT_LT(reference::norm(fenced(kBox, x) - reference::curl(box_potential, x, 1e-3)), 2e-3);
    if (const double radius = reference::norm(x); radius > 2.95 && radius < 3.99) {
      ++compared;
      EXPECT_LT(reference::norm(fenced(kSphere, x) - reference::curl(sphere_potential, x, 1e-3)), 2e-3);
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(Fence, LetsNothingThroughItsBorder) {
  Points points(1, 5);
  double worst = 0;
  for (int n = 0; n < 500; ++n) {
    Vec on_sphere = points.next();
    on_sphere = on_sphere * (4 / reference::norm(on_sphere));
    worst = std::max(worst, std::fabs(reference::dot(fenced(kSphere, on_sphere), on_sphere)) / 4);
    Vec on_face = in_box(points);
    const auto axis = static_cast<std::size_t>(n % 3);
    const double face = axis == 0 ? 4 : axis == 1 ? 3 : 2;
    on_face[axis] = n % 2 == 0 ? face : -face;
    worst = std::max(worst, std::fabs(fenced(kBox, on_face)[axis]));
  }
  EXPECT_LT(worst, 1e-5);
}

TEST(Fence, HasNoDivergenceAtEdgesAndCorners) {
  double worst = 0;
  for (int n = 0; n < 200; ++n) {
    const double below = 0.1 + 0.004 * n;
    const Vec x{4 - below, 3 - 0.9 * below - 0.03, 2 - 0.8 * below - 0.05};
    const double h = 0x1p-6;
    double divergence = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vec step{};
      step[axis] = h;
      divergence += (8 * (fenced(kBox, x + step)[axis] - fenced(kBox, x - step)[axis]) -
                     (fenced(kBox, x + step * 2)[axis] - fenced(kBox, x - step * 2)[axis])) /
                    (12 * h);
    }
    worst = std::max(worst, std::fabs(divergence));
  }
  // The stencil reaches over a lattice plane of the noise now and then, where its third derivative jumps.
  EXPECT_LT(worst, 0.02);
}

TEST(Fence, IsTheFreeCurlFromD0Inwards) {
  const MfNoise noise = test::noise_of(kSeed, 1.0F, 0.5F);
  Points points(0.9, 7);
  for (int n = 0; n < 100; ++n) {
    const Vec x = points.next();
    const Vec free = lane(mf_curl_noise(all_lanes(x), &noise, nullptr));
    EXPECT_LT(reference::norm(fenced(kBox, x) - free), 1e-6);
    EXPECT_LT(reference::norm(fenced(kSphere, x) - free), 1e-6);
  }
}

TEST(Fence, IsFiniteAtTheCentreOfASmallSphere) {
  const MfFence tiny{MF_FENCE_SPHERE, 0, 0, 0, 0.1F, 0.1F, 0.1F};
  for (const double c : fenced(tiny, {0, 0, 0})) {
    EXPECT_TRUE(std::isfinite(c));
  }
}

}  // namespace
}  // namespace mayfly::kernels
