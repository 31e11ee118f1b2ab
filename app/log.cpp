#include "app/log.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>

namespace mayfly::app {

void set_up_log(bool verbose) {
  auto logger = spdlog::stderr_color_st("mayfly");
  logger->set_pattern(verbose ? "%T.%e %^%l%$: %v" : "%^%l%$: %v");
  logger->set_level(verbose ? spdlog::level::debug : spdlog::level::warn);
  spdlog::set_default_logger(std::move(logger));
}

void log_detail(const std::string& text) {
  spdlog::info("{}", text);
}
void log_warning(const std::string& text) {
  spdlog::warn("{}", text);
}

void print_errors(std::span<const Error> errors) {
  for (const Error& error : errors) {
    fmt::print(stderr, "{}\n", to_string(error));
  }
}

}  // namespace mayfly::app
