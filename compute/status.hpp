// What an OpenCL call in the loop gives back: plain data, no allocation.
#pragma once

#include <string_view>

namespace mayfly::compute {

// `code` is OpenCL's own (0 is success, errors are negative).
struct [[nodiscard]] Status {
  int code = 0;
  bool ok() const noexcept { return code == 0; }
};

// "CL_INVALID_KERNEL_ARGS"; "unknown OpenCL error" for a code this program does not know.
std::string_view name_of(Status status) noexcept;

}  // namespace mayfly::compute
