#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "compute/program.hpp"

namespace mayfly::compute {
namespace {

constexpr std::string_view kSource = R"(
typedef struct { float factor; int offset; } Pair;
__kernel void scale(__global float* values, const int count, const Pair pair) {
  const int i = (int)get_global_id(0);
  if (i < count) values[i] = values[i] * pair.factor + (float)pair.offset;
}
__kernel void divide(__global float* a, __global const float* b) {
  const int i = (int)get_global_id(0);
  a[i] = a[i] / b[i] + sqrt(b[i]);
})";

struct Pair {
  float factor;
  int offset;
};

class KernelTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto device = Device::open();
    ASSERT_TRUE(device.has_value()) << to_string(device.error());
    device_.emplace(*device);
    auto program = Program::build_source(*device_, "test", kSource);
    ASSERT_TRUE(program.has_value()) << to_string(program.error());
    program_.emplace(*program);
  }
  std::optional<Device> device_;
  std::optional<Program> program_;
};

TEST_F(KernelTest, TakesBuffersNumbersAndStructs) {
  auto kernel = program_->kernel("scale");
  ASSERT_TRUE(kernel.has_value());
  auto values = Buffer<float>::create(*device_, 50);
  ASSERT_TRUE(values.has_value());
  std::iota(values->data().begin(), values->data().end(), 0.0F);
  ASSERT_TRUE(values->unmap().ok());
  ASSERT_TRUE(kernel->set(*values, 40, Pair{2.0F, 1}).ok());
  ASSERT_TRUE(kernel->enqueue(64, 16).ok());
  ASSERT_TRUE(kernel->enqueue(0, 16).ok());
  ASSERT_TRUE(device_->flush().ok());
  ASSERT_TRUE(device_->finish().ok());
  ASSERT_TRUE(values->map().ok());
  EXPECT_EQ(values->data()[3], 7.0F);
  EXPECT_EQ(values->data()[39], 79.0F);
  EXPECT_EQ(values->data()[40], 40.0F);
}

TEST_F(KernelTest, DividesAndTakesRootsAsTheHostDoes) {
  if (!device_->info().correctly_rounded) {
    GTEST_SKIP() << device_->info().name << " does not round division and root correctly";
  }
  constexpr std::size_t kCount = 4096;
  auto a = Buffer<float>::create(*device_, kCount);
  auto b = Buffer<float>::create(*device_, kCount);
  ASSERT_TRUE(a.has_value() && b.has_value());
  std::vector<float> expected;
  for (std::size_t i = 0; i < kCount; ++i) {
    const float x = a->data()[i] = 1.0F + 0.37F * static_cast<float>(i);
    const float y = b->data()[i] = 0.001F + 1.7F * static_cast<float>(i * i);
    expected.push_back(x / y + std::sqrt(y));
  }
  auto kernel = program_->kernel("divide");
  ASSERT_TRUE(kernel.has_value());
  ASSERT_TRUE(a->unmap().ok() && b->unmap().ok());
  ASSERT_TRUE(kernel->set(*a, *b).ok());
  ASSERT_TRUE(kernel->enqueue(kCount, 16).ok());
  ASSERT_TRUE(a->map().ok());
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), a->data().begin()));
}

TEST_F(KernelTest, WrongArgumentsAreAStatus) {
  auto kernel = program_->kernel("scale");
  ASSERT_TRUE(kernel.has_value());
  EXPECT_FALSE(kernel->enqueue(16, 16).ok());  // none are set
  EXPECT_FALSE(kernel->set(1, 2).ok());        // a number where a buffer belongs
  const Status status = kernel->enqueue(10, 16);
  EXPECT_FALSE(status.ok());
  EXPECT_EQ(name_of(status).substr(0, 3), "CL_");
  EXPECT_EQ(name_of(Status{-123456}), "unknown OpenCL error");
}

TEST_F(KernelTest, AnUnknownKernelIsAnError) {
  const auto kernel = program_->kernel("no_such");
  ASSERT_FALSE(kernel.has_value());
  EXPECT_EQ(kernel.error().found, "no_such");
  EXPECT_NE(kernel.error().message.find("CL_INVALID_KERNEL_NAME"), std::string::npos);
}

TEST_F(KernelTest, ABrokenSourceBringsTheCompilersWords) {
  const auto program =
      Program::build_source(*device_, "broken", "#line 7 \"kernels/broken.cl\"\n__kernel void f( {");
  ASSERT_FALSE(program.has_value());
  EXPECT_EQ(program.error().cause, Cause::kEnvironment);
  EXPECT_NE(program.error().message.find("broken.cl"), std::string::npos) << program.error().message;
  EXPECT_NE(program.error().message.find("error"), std::string::npos);
}

TEST_F(KernelTest, OutlivesTheProgramAndTheDevice) {
  auto kernel = program_->kernel("scale");
  auto values = Buffer<float>::create(*device_, 16);
  ASSERT_TRUE(kernel.has_value() && values.has_value());
  program_.reset();
  device_.reset();
  values->data()[0] = 1.0F;
  ASSERT_TRUE(values->unmap().ok());
  ASSERT_TRUE(kernel->set(*values, 16, Pair{3.0F, 0}).ok());
  ASSERT_TRUE(kernel->enqueue(16, 16).ok());
  ASSERT_TRUE(values->map().ok());
  EXPECT_EQ(values->data()[0], 3.0F);
}

}  // namespace
}  // namespace mayfly::compute
