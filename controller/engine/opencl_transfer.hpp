// How the stages of the OpenCL engine hand columns to the device.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <span>

#include "compute/buffer.hpp"

namespace mayfly::opencl {

inline constexpr std::size_t kGroup = 64;  // work items launched together

inline std::size_t whole_groups(std::size_t items) noexcept {
  return (items + kGroup - 1) / kGroup * kGroup;
}

inline compute::Status first_fault(std::initializer_list<compute::Status> all) noexcept {
  for (const compute::Status status : all) {
    if (!status.ok()) {
      return status;
    }
  }
  return {};
}

// As many as there are, have room and are wanted. Leaves the buffer with the device.
template <class T, class From>
compute::Status send(compute::Buffer<T>& to, std::span<From> from,
                     std::size_t wanted = std::numeric_limits<std::size_t>::max()) noexcept {
  if (const compute::Status status = to.map(); !status.ok()) {
    return status;
  }
  std::copy_n(from.begin(), std::min({from.size(), to.size(), wanted}), to.data().begin());
  return to.unmap();
}

}  // namespace mayfly::opencl
