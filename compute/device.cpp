#include "compute/device.hpp"

#include <cstdlib>

#include "compute/handles.hpp"

namespace mayfly::compute {

namespace {

// OpenCL hands out every list and every text in the same two steps: how long, then what.
template <class Query>
std::string text_of(const Query& query) {
  std::size_t size = 0;
  if (query(0, nullptr, &size) != CL_SUCCESS || size == 0) {
    return {};
  }
  std::string text(size, '\0');
  if (query(size, text.data(), nullptr) != CL_SUCCESS) {
    return {};
  }
  text.resize(size - 1);  // the terminating zero
  return text;
}

template <class T>
T number_of(cl_device_id device, cl_device_info what) {
  T value{};
  clGetDeviceInfo(device, what, sizeof value, &value, nullptr);
  return value;
}

DeviceInfo describe(cl_platform_id platform, cl_device_id device) {
  const auto text = [device](cl_device_info what) {
    return text_of([&](std::size_t size, void* to, std::size_t* needed) {
      return clGetDeviceInfo(device, what, size, to, needed);
    });
  };
  DeviceInfo info;
  info.platform = text_of([&](std::size_t size, void* to, std::size_t* needed) {
    return clGetPlatformInfo(platform, CL_PLATFORM_NAME, size, to, needed);
  });
  info.name = text(CL_DEVICE_NAME);
  info.vendor = text(CL_DEVICE_VENDOR);
  info.version = text(CL_DEVICE_VERSION);
  info.driver = text(CL_DRIVER_VERSION);
  info.compute_units = number_of<cl_uint>(device, CL_DEVICE_MAX_COMPUTE_UNITS);
  info.is_cpu = (number_of<cl_device_type>(device, CL_DEVICE_TYPE) & CL_DEVICE_TYPE_CPU) != 0;
  const auto precision = number_of<cl_device_fp_config>(device, CL_DEVICE_SINGLE_FP_CONFIG);
  info.correctly_rounded = (precision & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
  return info;
}

struct Found {
  cl_device_id device;
  DeviceInfo info;
};

std::vector<Found> find_devices() {
  cl_uint platforms = 0;
  if (clGetPlatformIDs(0, nullptr, &platforms) != CL_SUCCESS || platforms == 0) {
    return {};
  }
  std::vector<cl_platform_id> platform_ids(platforms);
  clGetPlatformIDs(platforms, platform_ids.data(), nullptr);
  std::vector<Found> found;
  for (cl_platform_id platform : platform_ids) {
    cl_uint devices = 0;
    if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &devices) != CL_SUCCESS || devices == 0) {
      continue;
    }
    std::vector<cl_device_id> device_ids(devices);
    clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, devices, device_ids.data(), nullptr);
    for (cl_device_id device : device_ids) {
      found.push_back({device, describe(platform, device)});
    }
  }
  return found;
}

std::string label(const DeviceInfo& info) {
  return info.platform + ' ' + info.name;
}

tl::unexpected<Error> no_such_device(std::string_view wanted, const std::vector<Found>& found) {
  if (found.empty()) {
    return fail(Cause::kEnvironment,
                "no OpenCL device on this machine; the package pocl-opencl-icd brings one");
  }
  Error error{Cause::kEnvironment, "no OpenCL device of that name"};
  error.found = std::string(wanted);
  for (const Found& each : found) {
    error.wanted += (error.wanted.empty() ? "part of '" : "', '") + label(each.info);
  }
  error.wanted += '\'';
  return fail(std::move(error));
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> infos;
  for (Found& each : find_devices()) {
    infos.push_back(std::move(each.info));
  }
  return infos;
}

Result<Device> Device::open(std::string_view wanted) {
  if (const char* preferred = std::getenv("MAYFLY_OPENCL_DEVICE"); wanted.empty() && preferred != nullptr) {
    wanted = preferred;
  }
  std::vector<Found> found = find_devices();
  for (Found& each : found) {
    if (label(each.info).find(wanted) == std::string::npos) {
      continue;
    }
    auto handles = std::make_shared<DeviceHandles>();
    handles->info = std::move(each.info);
    handles->device = each.device;
    cl_int code = CL_SUCCESS;
    handles->context.reset(clCreateContext(nullptr, 1, &each.device, nullptr, nullptr, &code));
    if (code != CL_SUCCESS) {
      return opencl_error("clCreateContext", code, handles->info);
    }
    handles->queue.reset(clCreateCommandQueue(handles->context.get(), each.device, 0, &code));
    if (code != CL_SUCCESS) {
      return opencl_error("clCreateCommandQueue", code, handles->info);
    }
    return Device(std::move(handles));
  }
  return no_such_device(wanted, found);
}

const DeviceInfo& Device::info() const noexcept {
  return handles_->info;
}

Status Device::flush() const noexcept {
  return {clFlush(handles_->queue.get())};
}

Status Device::finish() const noexcept {
  return {clFinish(handles_->queue.get())};
}

}  // namespace mayfly::compute
