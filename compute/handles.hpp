// This room's own view of OpenCL: handles that release themselves. Only compute/*.cpp include this.
#pragma once

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

#include <memory>
#include <type_traits>

#include "compute/device.hpp"

namespace mayfly::compute {

template <auto Release>
struct Releaser {
  template <class T>
  void operator()(T* handle) const noexcept {
    Release(handle);
  }
};
template <class Handle, auto Release>
using Unique = std::unique_ptr<std::remove_pointer_t<Handle>, Releaser<Release>>;

using UniqueContext = Unique<cl_context, clReleaseContext>;
using UniqueQueue = Unique<cl_command_queue, clReleaseCommandQueue>;
using UniqueProgram = Unique<cl_program, clReleaseProgram>;

struct DeviceHandles {
  DeviceInfo info;
  cl_device_id device = nullptr;
  UniqueContext context;
  UniqueQueue queue;
};

// "clBuildProgram: CL_BUILD_PROGRAM_FAILURE on pthread-…"
inline tl::unexpected<Error> opencl_error(const char* call, int code, const DeviceInfo& info) {
  return fail(Cause::kEnvironment,
              std::string(call) + ": " + std::string(name_of(Status{code})) + " on " + info.name);
}

}  // namespace mayfly::compute
