#include "compute/program.hpp"

#include <atomic>

#include "compute/handles.hpp"
#include "compute/program_cache.hpp"
#include "compute/sources.hpp"

namespace mayfly::compute {

struct Kernel::State {
  std::shared_ptr<const DeviceHandles> device;
  Unique<cl_kernel, clReleaseKernel> kernel;
};

void Kernel::Deleter::operator()(State* state) const noexcept {
  delete state;
}

struct Program::State {
  std::shared_ptr<const DeviceHandles> device;
  UniqueProgram program;
  bool from_cache = false;
};

namespace {

struct AtomicCounters {
  std::atomic<std::uint64_t> compiled{0}, from_cache{0}, rejected{0}, unstored{0};
};
AtomicCounters& counters() {
  static AtomicCounters instance;
  return instance;
}

std::string all_options(const DeviceInfo& info, std::string_view more) {
  std::string options = "-cl-std=CL1.2";
  if (info.correctly_rounded) {
    options += " -cl-fp32-correctly-rounded-divide-sqrt";
  }
  if (!more.empty()) {
    options += ' ' + std::string(more);
  }
  return options;
}

// All that a binary depends on.
std::string key_of(const DeviceInfo& info, std::string_view source, const std::string& options) {
  std::string key;
  for (const std::string& part : {info.platform, info.name, info.version, info.driver, options}) {
    key += part + '\n';
  }
  return key + std::string(source);
}

std::string build_log(cl_program program, cl_device_id device) {
  std::size_t size = 0;
  clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size);
  std::string log(size, '\0');
  clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, size, log.data(), nullptr);
  while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) {
    log.pop_back();
  }
  return log;
}

Binary binary_of(cl_program program) {
  std::size_t size = 0;
  if (clGetProgramInfo(program, CL_PROGRAM_BINARY_SIZES, sizeof size, &size, nullptr) != CL_SUCCESS) {
    return {};
  }
  Binary binary(size);
  unsigned char* data = binary.data();
  if (clGetProgramInfo(program, CL_PROGRAM_BINARIES, sizeof(unsigned char*), static_cast<void*>(&data),
                       nullptr) != CL_SUCCESS) {
    return {};
  }
  return binary;
}

UniqueProgram build_cached(const DeviceHandles& handles, const std::string& key, const std::string& options) {
  const CachedBinary cached = load_binary(key);
  if (cached.lookup == Lookup::kMissing) {
    return nullptr;
  }
  if (cached.lookup == Lookup::kFound) {
    const std::size_t size = cached.binary.size();
    const unsigned char* data = cached.binary.data();
    cl_int code = CL_SUCCESS;
    cl_int accepted = CL_SUCCESS;
    UniqueProgram program(
        clCreateProgramWithBinary(handles.context.get(), 1, &handles.device, &size, &data, &accepted, &code));
    if (code == CL_SUCCESS && accepted == CL_SUCCESS &&
        clBuildProgram(program.get(), 1, &handles.device, options.c_str(), nullptr, nullptr) == CL_SUCCESS) {
      return program;
    }
  }
  ++counters().rejected;
  return nullptr;
}

Result<UniqueProgram> compile(const DeviceHandles& handles, std::string_view name, std::string_view source,
                              const std::string& options) {
  const char* text = source.data();
  const std::size_t length = source.size();
  cl_int code = CL_SUCCESS;
  UniqueProgram program(clCreateProgramWithSource(handles.context.get(), 1, &text, &length, &code));
  if (code != CL_SUCCESS) {
    return opencl_error("clCreateProgramWithSource", code, handles.info);
  }
  code = clBuildProgram(program.get(), 1, &handles.device, options.c_str(), nullptr, nullptr);
  if (code != CL_SUCCESS) {
    auto error = opencl_error("clBuildProgram", code, handles.info);
    error.value().message += ", kernels '" + std::string(name) + "', options " + options + ":\n" +
                             build_log(program.get(), handles.device);
    return error;
  }
  return program;
}

}  // namespace

Result<Program> Program::build(const Device& device, std::string_view name, std::string_view options) {
  auto source = kernel_source(name);
  if (!source) {
    return fail(std::move(source.error()));
  }
  return build_source(device, name, *source, options);
}

Result<Program> Program::build_source(const Device& device, std::string_view name, std::string_view source,
                                      std::string_view options) {
  auto state = std::make_shared<State>();
  state->device = device.handles();
  const std::string full_options = all_options(device.info(), options);
  const std::string key = key_of(device.info(), source, full_options);
  state->program = build_cached(*state->device, key, full_options);
  state->from_cache = state->program != nullptr;
  if (state->from_cache) {
    ++counters().from_cache;
    return Program(std::move(state));
  }
  auto compiled = compile(*state->device, name, source, full_options);
  if (!compiled) {
    return fail(std::move(compiled.error()));
  }
  ++counters().compiled;
  state->program = std::move(*compiled);
  const Binary binary = binary_of(state->program.get());
  if (binary.empty() || !store_binary(key, binary)) {
    ++counters().unstored;
  }
  return Program(std::move(state));
}

Result<Kernel> Program::kernel(const std::string& name) const {
  cl_int code = CL_SUCCESS;
  Kernel kernel(new Kernel::State{state_->device, nullptr});
  kernel.state_->kernel.reset(clCreateKernel(state_->program.get(), name.c_str(), &code));
  if (code != CL_SUCCESS) {
    auto error = opencl_error("clCreateKernel", code, state_->device->info);
    error.value().found = name;
    return error;
  }
  return kernel;
}

bool Program::from_cache() const noexcept {
  return state_->from_cache;
}

ProgramCounters program_counters() noexcept {
  const AtomicCounters& now = counters();
  return {now.compiled, now.from_cache, now.rejected, now.unstored};
}

Status Kernel::set_raw(unsigned index, std::size_t size, const void* value) noexcept {
  return {clSetKernelArg(state_->kernel.get(), index, size, value)};
}

Status Kernel::enqueue(std::size_t items, std::size_t group) noexcept {
  if (items == 0) {
    return {};
  }
  return {clEnqueueNDRangeKernel(state_->device->queue.get(), state_->kernel.get(), 1, nullptr, &items,
                                 &group, 0, nullptr, nullptr)};
}

}  // namespace mayfly::compute
