// Swarms that integrate forces: the same bits from both engines.
#include <gtest/gtest.h>

#include "tests/unit/engine/forced_cases.hpp"

namespace mayfly {
namespace {

class ForcedSwarms : public testing::TestWithParam<test::ForcedCase> {};

TEST_P(ForcedSwarms, FlyAlikeOnBothEngines) {
  auto opencl = make_opencl_engine();
  ASSERT_TRUE(opencl) << to_string(opencl.error());
  const auto native = test::flown(*make_native_engine(1), GetParam());
  EXPECT_TRUE(test::flown(**opencl, GetParam()) == native);
  EXPECT_FALSE(native.front() == native.back());
}

INSTANTIATE_TEST_SUITE_P(All, ForcedSwarms, test::forced_cases(), test::name_of);

}  // namespace
}  // namespace mayfly
