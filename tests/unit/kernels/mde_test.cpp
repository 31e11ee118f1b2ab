#include "kernels/mde.h"

#include <gtest/gtest.h>

#include "tests/unit/kernels/lanes.hpp"

namespace mayfly::kernels {
namespace {

using namespace kernels;
using reference::Vec;
using test::all_lanes;
using test::lane;
using test::Points;

F3 push(Vec r, Vec q, float distance, int self = 0, int other = 1) {
  const F3 line = mf3_sub(all_lanes(r), all_lanes(q));
  return mf_push(line, mf_splat(distance), mf_too_near(line, mf_splat(distance)),
                 mf_parting(mf_isplat(self), mf_isplat(other)));
}

TEST(Push, HalfOfTheOverlapEachAlongTheLine) {
  Points points(1);
  for (int n = 0; n < 500; ++n) {
    const Vec r = points.next();
    const Vec q = points.next();
    const double length = reference::norm(r - q);
    const Vec moved = lane(push(r, q, 1.2F));
    if (length >= 1.2F) {
      EXPECT_EQ(reference::norm(moved), 0);
      continue;
    }
    const Vec expected = (r - q) * (0.5 * (1.2F - length) / length);
    EXPECT_LT(reference::norm(moved - expected), 1e-6);
    const Vec after = (r + moved) - (q + lane(push(q, r, 1.2F)));
    EXPECT_NEAR(reference::norm(after), 1.2F, 1e-6);
  }
}

TEST(Push, CoincidentAgentsPartInOppositeDirections) {
  for (int other = 1; other < 50; ++other) {
    const Vec a = lane(push({1, 2, 3}, {1, 2, 3}, 0.5F, 0, other));
    const Vec b = lane(push({1, 2, 3}, {1, 2, 3}, 0.5F, other, 0));
    EXPECT_NEAR(reference::norm(a), 0.25, 1e-6);
    EXPECT_LT(reference::norm(a + b), 1e-7);
  }
}

TEST(Push, IgnoresLanesThatDoNotCount) {
  const F3 moved =
      mf_push(all_lanes({0.1, 0, 0}), mf_splat(1.0F), mf_isplat(0), mf_parting(mf_isplat(0), mf_isplat(1)));
  EXPECT_EQ(reference::norm(lane(moved)), 0);
}

}  // namespace
}  // namespace mayfly::kernels
