// Memory that host and device both see; on a CPU device nothing is copied.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

#include "compute/device.hpp"

namespace mayfly::compute {

class RawBuffer {
 public:
  // `bytes` may be 0: OpenCL knows no empty buffer, so one byte is taken. Mapped and zeroed.
  static Result<RawBuffer> create(const Device& device, std::size_t bytes);
  RawBuffer(RawBuffer&&) noexcept;
  RawBuffer& operator=(RawBuffer&&) noexcept;
  ~RawBuffer();

  // Hands the memory to the host, after all that was enqueued before; a no-op where it already has it.
  Status map() noexcept;
  // Hands it to the device; a no-op where it already has it.
  Status unmap() noexcept;
  // Null while the device has it.
  void* data() noexcept;
  std::size_t bytes() const noexcept;
  // The cl_mem, as clSetKernelArg wants it.
  const void* argument() const noexcept;

 private:
  struct State;
  explicit RawBuffer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

// `count` elements, zeroed. The host may look while it is mapped, which it is at first and after each map();
// kernels may run on it while it is not.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  static Result<Buffer> create(const Device& device, std::size_t count) {
    auto raw = RawBuffer::create(device, count * sizeof(T));
    if (!raw) {
      return fail(std::move(raw.error()));
    }
    return Buffer(std::move(*raw), count);
  }
  // A copy of `values`, already handed to the device.
  static Result<Buffer> create_from(const Device& device, std::span<const T> values) {
    auto buffer = create(device, values.size());
    if (buffer) {
      std::copy(values.begin(), values.end(), buffer->data().begin());
      if (const Status status = buffer->unmap(); !status.ok()) {
        return fail(Cause::kEnvironment, "OpenCL buffer: " + std::string(name_of(status)));
      }
    }
    return buffer;
  }

  Status map() noexcept { return raw_.map(); }
  Status unmap() noexcept { return raw_.unmap(); }
  // Empty while the device has it. The address may change from one map() to the next.
  std::span<T> data() noexcept {
    void* data = raw_.data();
    return data == nullptr ? std::span<T>{} : std::span<T>{static_cast<T*>(data), count_};
  }
  std::size_t size() const noexcept { return count_; }
  const RawBuffer& raw() const noexcept { return raw_; }

 private:
  Buffer(RawBuffer raw, std::size_t count) : raw_(std::move(raw)), count_(count) {}
  RawBuffer raw_;
  std::size_t count_;
};

}  // namespace mayfly::compute
