// OpenCL devices: what this machine has, and one of them opened. No OpenCL header shows through.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compute/status.hpp"
#include "core/result.hpp"

namespace mayfly::compute {

struct DeviceInfo {
  std::string platform;
  std::string name;
  std::string vendor;
  std::string version;  // of OpenCL, as the device tells it
  std::string driver;
  unsigned compute_units = 0;
  bool is_cpu = false;
  bool correctly_rounded = false;  // single-precision ÷ and √ give the same bits as a CPU's
};

// Every device of every platform; empty where no OpenCL runtime is installed.
std::vector<DeviceInfo> list_devices();

struct DeviceHandles;  // compute/handles.hpp, for this room's own files

// A device with a context and one in-order queue. A copy is another handle on the same queue; one thread at a
// time may enqueue on it.
class Device {
 public:
  // The first device whose "platform name" text contains `wanted`; if that is empty, the environment's
  // MAYFLY_OPENCL_DEVICE; if that is unset, the first GPU-or-CPU that the runtime offers.
  // Fails (environment) where there is no such device; the message lists those there are.
  static Result<Device> open(std::string_view wanted = {});

  const DeviceInfo& info() const noexcept;
  // Lets the device begin what was enqueued.
  Status flush() const noexcept;
  // Returns when all that was enqueued is done.
  Status finish() const noexcept;

  const std::shared_ptr<const DeviceHandles>& handles() const noexcept { return handles_; }

 private:
  explicit Device(std::shared_ptr<const DeviceHandles> handles) : handles_(std::move(handles)) {}
  std::shared_ptr<const DeviceHandles> handles_;
};

}  // namespace mayfly::compute
