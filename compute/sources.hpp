// The OpenCL sources that were embedded at build time, each flattened: `#include "kernels/x.h"` replaced by
// its text, once.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace mayfly::compute {

struct EmbeddedSource {
  std::string_view name;  // "plants" for kernels/plants.cl
  std::string_view text;
};
std::span<const EmbeddedSource> embedded_sources() noexcept;

// The embedded text of kernels/`name`.cl; while developing, if MAYFLY_KERNEL_DIR names the kernels folder,
// what stands there now. Fails (caller) for an unknown name, (environment) for a file that cannot be read.
Result<std::string> kernel_source(std::string_view name);

// What the build does for each file of the folder, done now.
Result<std::string> flatten_kernel(const std::filesystem::path& kernel_folder, std::string_view name);

}  // namespace mayfly::compute
