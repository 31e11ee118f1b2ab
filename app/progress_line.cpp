#include "app/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace mayfly::app {
namespace {

constexpr std::chrono::seconds kPatience{2};
constexpr auto kClearLine = "\r\033[K";

}  // namespace

ProgressLine::ProgressLine(bool wanted)
    : wanted_(wanted && isatty(STDERR_FILENO) == 1), start_(std::chrono::steady_clock::now()) {}

void ProgressLine::show(std::string_view text) {
  if (!wanted_ || std::chrono::steady_clock::now() - start_ < kPatience) {
    return;
  }
  const std::lock_guard lock(mutex_);
  fmt::print(stderr, "{}{}", kClearLine, text);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_) {
    fmt::print(stderr, "{}", kClearLine);
    std::fflush(stderr);
    shown_ = false;
  }
}

Progress ProgressLine::stages() {
  if (!wanted_) {
    return {};
  }
  return [this](std::string_view stage, double fraction) {
    show(fmt::format("{} {:.0f} %", stage, 100.0 * fraction));
  };
}

}  // namespace mayfly::app
