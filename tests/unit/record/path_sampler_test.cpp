#include "record/path_sampler.hpp"

#include <gtest/gtest.h>

#include "tests/unit/record/frames.hpp"

namespace mayfly::record {
namespace {

std::vector<PathSampler::Row> fly(PathSampler& sampler, test::Frames& frames, std::uint64_t ticks) {
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    for (std::size_t a = 0; a < frames.kinds.size(); ++a) {
      frames.numbers[0][a] = static_cast<float>(tick);
      frames.numbers[1][a] = static_cast<float>(a);
    }
    sampler.on_tick(frames.at(tick));
  }
  return sampler.rows();
}

TEST(PathSampler, KeepsEndsAndEvenSpacingInBoundedMemory) {
  for (const std::uint64_t ticks : {1U, 2U, 399U, 400U, 401U, 5003U, 20'001U}) {
    PathSampler sampler(3);
    test::Frames frames(3);
    const auto rows = fly(sampler, frames, ticks);
    ASSERT_FALSE(rows.empty());
    EXPECT_LE(rows.size(), PathSampler::kMaxRows + 1);
    EXPECT_GE(rows.size(), std::min<std::size_t>(ticks, PathSampler::kMaxRows / 2));
    EXPECT_EQ(rows.front().positions[0].x, 0.0F);
    EXPECT_EQ(rows.back().positions[2].x, static_cast<float>(ticks - 1));
    for (std::size_t i = 0; i + 2 < rows.size(); ++i) {
      EXPECT_NEAR(rows[i + 1].time_s - rows[i].time_s, rows[1].time_s - rows[0].time_s, 1e-9);
      EXPECT_NEAR(rows[i].positions[1].x, 100.0 * rows[i].time_s, 1e-3);
    }
  }
}

TEST(PathSampler, SpreadsOverALargeSwarm) {
  PathSampler sampler(10'000);
  test::Frames frames(10'000);
  const auto rows = fly(sampler, frames, 1);
  ASSERT_EQ(rows.front().positions.size(), PathSampler::kMaxPaths);
  EXPECT_EQ(rows.front().positions[0].y, 0.0F);
  EXPECT_EQ(rows.front().positions[1999].y, 9995.0F);
}

TEST(PathSampler, NobodyAndNothing) {
  PathSampler sampler(0);
  EXPECT_TRUE(sampler.rows().empty());
  test::Frames frames(0);
  EXPECT_TRUE(fly(sampler, frames, 2).front().positions.empty());
}

}  // namespace
}  // namespace mayfly::record
