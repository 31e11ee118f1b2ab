#include "compute/device.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "compute/buffer.hpp"

namespace mayfly::compute {
namespace {

TEST(Device, ThisMachineHasOne) {
  const auto devices = list_devices();
  ASSERT_FALSE(devices.empty());
  EXPECT_FALSE(devices[0].name.empty());
  EXPECT_FALSE(devices[0].platform.empty());
  EXPECT_FALSE(devices[0].driver.empty());
  EXPECT_GT(devices[0].compute_units, 0U);
}

TEST(Device, IsChosenByPartOfItsName) {
  const DeviceInfo wanted = list_devices().at(0);
  const auto device = Device::open(std::string_view(wanted.name).substr(1));
  ASSERT_TRUE(device.has_value()) << to_string(device.error());
  EXPECT_EQ(device->info().name, wanted.name);
}

TEST(Device, AnUnknownNameIsRefusedWithThoseThereAre) {
  const auto device = Device::open("abacus");
  ASSERT_FALSE(device.has_value());
  EXPECT_EQ(device.error().cause, Cause::kEnvironment);
  EXPECT_EQ(device.error().found, "abacus");
  EXPECT_NE(device.error().wanted.find(list_devices().at(0).name), std::string::npos);
}

TEST(Device, TheEnvironmentChoosesWhereNobodyElseDoes) {
  setenv("MAYFLY_OPENCL_DEVICE", "abacus", 1);
  EXPECT_FALSE(Device::open().has_value());
  EXPECT_TRUE(Device::open(list_devices().at(0).name).has_value());
  unsetenv("MAYFLY_OPENCL_DEVICE");
  EXPECT_TRUE(Device::open().has_value());
}

TEST(Buffer, IsMappedAndZeroAtFirst) {
  const auto device = Device::open();
  ASSERT_TRUE(device.has_value());
  auto buffer = Buffer<float>::create(*device, 100);
  ASSERT_TRUE(buffer.has_value());
  ASSERT_EQ(buffer->data().size(), 100U);
  EXPECT_EQ(buffer->data()[99], 0.0F);
}

TEST(Buffer, KeepsItsValuesOverHandingBackAndForth) {
  const auto device = Device::open();
  ASSERT_TRUE(device.has_value());
  const std::vector<int> values{1, 2, 3};
  auto buffer = Buffer<int>::create_from(*device, values);
  ASSERT_TRUE(buffer.has_value());
  EXPECT_TRUE(buffer->data().empty());  // the device has it
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(buffer->map().ok());
    ASSERT_TRUE(buffer->map().ok());
    EXPECT_EQ(buffer->data()[2], 3 + round);
    ++buffer->data()[2];
    ASSERT_TRUE(buffer->unmap().ok());
    ASSERT_TRUE(buffer->unmap().ok());
  }
}

TEST(Buffer, MayBeEmpty) {
  const auto device = Device::open();
  ASSERT_TRUE(device.has_value());
  auto buffer = Buffer<float>::create(*device, 0);
  ASSERT_TRUE(buffer.has_value());
  EXPECT_EQ(buffer->size(), 0U);
  EXPECT_TRUE(buffer->data().empty());
}

TEST(Buffer, OneLargerThanTheDeviceIsAnError) {
  const auto device = Device::open();
  ASSERT_TRUE(device.has_value());
  const auto buffer = Buffer<float>::create(*device, std::size_t{1} << 50U);
  ASSERT_FALSE(buffer.has_value());
  EXPECT_NE(buffer.error().message.find("clCreateBuffer"), std::string::npos);
}

}  // namespace
}  // namespace mayfly::compute
