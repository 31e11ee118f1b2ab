#include "compute/buffer.hpp"

#include <cstring>

#include "compute/handles.hpp"

namespace mayfly::compute {

struct RawBuffer::State {
  std::shared_ptr<const DeviceHandles> device;
  Unique<cl_mem, clReleaseMemObject> memory;
  cl_mem argument = nullptr;
  std::size_t bytes = 0;
  void* mapped = nullptr;
};

RawBuffer::RawBuffer(std::unique_ptr<State> state) : state_(std::move(state)) {}
RawBuffer::RawBuffer(RawBuffer&&) noexcept = default;
RawBuffer& RawBuffer::operator=(RawBuffer&&) noexcept = default;
RawBuffer::~RawBuffer() {
  if (state_) {
    static_cast<void>(unmap());  // a failure here leaves nothing to mend
  }
}

Result<RawBuffer> RawBuffer::create(const Device& device, std::size_t bytes) {
  auto state = std::make_unique<State>();
  state->device = device.handles();
  state->bytes = std::max<std::size_t>(bytes, 1);
  cl_int code = CL_SUCCESS;
  state->memory.reset(clCreateBuffer(state->device->context.get(), CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR,
                                     state->bytes, nullptr, &code));
  if (code != CL_SUCCESS) {
    return opencl_error("clCreateBuffer", code, device.info());
  }
  state->argument = state->memory.get();
  RawBuffer buffer(std::move(state));
  if (const Status status = buffer.map(); !status.ok()) {
    return opencl_error("clEnqueueMapBuffer", status.code, device.info());
  }
  std::memset(buffer.data(), 0, buffer.bytes());
  return buffer;
}

Status RawBuffer::map() noexcept {
  if (state_->mapped != nullptr) {
    return {};
  }
  cl_int code = CL_SUCCESS;
  state_->mapped =
      clEnqueueMapBuffer(state_->device->queue.get(), state_->argument, CL_TRUE, CL_MAP_READ | CL_MAP_WRITE,
                         0, state_->bytes, 0, nullptr, nullptr, &code);
  return {code};
}

Status RawBuffer::unmap() noexcept {
  if (state_->mapped == nullptr) {
    return {};
  }
  void* const mapped = std::exchange(state_->mapped, nullptr);
  return {
      clEnqueueUnmapMemObject(state_->device->queue.get(), state_->argument, mapped, 0, nullptr, nullptr)};
}

void* RawBuffer::data() noexcept {
  return state_->mapped;
}
std::size_t RawBuffer::bytes() const noexcept {
  return state_->bytes;
}
const void* RawBuffer::argument() const noexcept {
  return &state_->argument;
}

}  // namespace mayfly::compute
