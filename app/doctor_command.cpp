#include "app/doctor_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <thread>

#include "app/doctor_realtime.hpp"
#include "app/exit_code.hpp"
#include "compute/device.hpp"
#include "core/cache_directory.hpp"
#include "kernels/lane.h"

namespace mayfly::app {
namespace {

std::vector<Finding> look_at_processors() {
  const unsigned cores = std::thread::hardware_concurrency();
#if defined(__AVX512F__)
  constexpr auto kInstructions = "AVX-512";
#elif defined(__AVX2__)
  constexpr auto kInstructions = "AVX2";
#elif defined(__ARM_NEON)
  constexpr auto kInstructions = "NEON";
#else
  constexpr auto kInstructions = "the compiler's default instructions";
#endif
  return {{cores > 1, "processors", fmt::format("{}", cores),
           cores > 1 ? "" : "flights work; the operating system and the control loop share the one there is"},
          {true, "native engine", fmt::format("{} lanes, compiled for {}", MF_LANES, kInstructions), ""}};
}

std::vector<Finding> look_at_opencl() {
  std::vector<Finding> findings;
  for (const compute::DeviceInfo& device : compute::list_devices()) {
    findings.push_back(
        {true, "OpenCL device",
         fmt::format("{} on {} ({}, {} compute unit{}{})", device.name, device.platform, device.version,
                     device.compute_units, device.compute_units == 1 ? "" : "s",
                     device.correctly_rounded ? ", correctly rounded ÷ and √" : ""),
         ""});
  }
  if (findings.empty()) {
    findings.push_back({false, "OpenCL device", "none; --engine native flies without",
                        "apt-get install pocl-opencl-icd (on the processor), or your GPU vendor's runtime"});
  }
  return findings;
}

// Writable, or can be made: asked without making it.
Finding look_at_cache() {
  const auto folder = cache_directory();
  if (!folder) {
    return {false, "cache", "no place for it: fields are computed anew every time",
            "set HOME or MAYFLY_CACHE_DIR"};
  }
  auto there = *folder;
  std::error_code failure;
  while (!std::filesystem::exists(there, failure) && there.has_relative_path()) {
    there = there.parent_path();
  }
  const bool writable = access(there.c_str(), W_OK) == 0;
  return {writable, "cache", fmt::format("{}{}", folder->string(), writable ? "" : " cannot be written"),
          writable ? "" : "make it writable, or set MAYFLY_CACHE_DIR"};
}

void print(const Finding& finding) {
  fmt::print("{:<8} {:<20} {}\n", finding.ok ? "ok" : "missing", finding.name, finding.what);
  if (!finding.remedy.empty()) {
    fmt::print("{:<8} {:<20} -> {}\n", "", "", finding.remedy);
  }
}

void print_all(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    print(finding);
  }
}

}  // namespace

int doctor() {
  print_all(look_at_processors());
  print_all(look_at_opencl());
  print_all(look_at_realtime());
  print(look_at_cache());
  return kSuccess;
}

}  // namespace mayfly::app
