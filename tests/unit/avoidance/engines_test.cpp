// Both engines: the same bits.
#include <gtest/gtest.h>

#include "tests/unit/avoidance/crowd.hpp"

namespace mayfly {
namespace {

using test::Crowd;

class AvoidanceOfSize : public testing::TestWithParam<std::size_t> {};

TEST_P(AvoidanceOfSize, GivesTheSameBitsNativeAndOpencl) {
  auto opencl = make_opencl_engine();
  ASSERT_TRUE(opencl) << to_string(opencl.error());
  for (const bool second_avoids : {true, false}) {
    const Crowd crowd(GetParam(), second_avoids);
    expect_same(third_tick(*make_native_engine(1), crowd), third_tick(**opencl, crowd));
  }
}
INSTANTIATE_TEST_SUITE_P(Sizes, AvoidanceOfSize, testing::Values(1, 2, 9, 300, 5000));

}  // namespace
}  // namespace mayfly
