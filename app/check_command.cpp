#include "app/check_command.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <utility>

#include "app/exit_code.hpp"
#include "app/log.hpp"
#include "app/progress_line.hpp"
#include "controller/flight/placement.hpp"
#include "controller/flight/start_check.hpp"
#include "controller/flight/world.hpp"
#include "controller/scenario/load.hpp"
#include "record/grouped_digits.hpp"

namespace mayfly::app {
namespace {

// All that run() does before it flies; nothing is kept but what the field cache keeps.
std::vector<Error> check_one(const std::filesystem::path& file, const CheckOptions& options) {
  const auto scenario = load_scenario(file, options.overrides);
  if (!scenario) {
    return scenario.error();
  }
  for (const Error& warning : scenario->warnings) {
    log_warning(to_string(warning));
  }
  ProgressLine line(true);
  const auto start = std::chrono::steady_clock::now();
  const auto world = build_world(*scenario, options.threads, line.stages());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  line.clear();
  if (!world) {
    return world.error();
  }
  for (const Error& warning : world->warnings) {
    log_warning(to_string(warning));
  }
  const auto positions = place_agents(*scenario, *world);
  if (!positions) {
    return positions.error();
  }
  if (auto safe = check_start(*scenario, *world, *positions); !safe) {
    return {std::move(safe.error())};
  }
  fmt::print("{}: ok ({} agent{}, {} cells, {} triangles; fields {:.2f} s)\n", scenario->name,
             record::grouped_digits(positions->size(), " "), positions->size() == 1 ? "" : "s",
             record::grouped_digits(world->grid.size(), " "),
             record::grouped_digits(world->solid.triangle_count(), " "), seconds);
  return {};
}

}  // namespace

int check(const CheckOptions& options) {
  set_up_log(options.verbose);
  int code = kSuccess;
  for (const std::filesystem::path& file : options.scenarios) {
    const auto errors = check_one(file, options);
    std::fflush(stdout);
    print_errors(errors);
    for (const Error& error : errors) {
      // Bad input is what a caller can mend, so it is told before a machine's failure.
      code = code == kBadInput ? code : exit_code_of(error);
    }
  }
  return code;
}

}  // namespace mayfly::app
