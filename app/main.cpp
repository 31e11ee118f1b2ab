// The command-line program.
#include <cstdio>
#include <exception>
#include <variant>

#include "app/arguments.hpp"
#include "app/bench_command.hpp"
#include "app/check_command.hpp"
#include "app/doctor_command.hpp"
#include "app/exit_code.hpp"
#include "app/guard_command.hpp"
#include "app/run_command.hpp"
#include "app/test_command.hpp"

namespace {

struct Runner {
  int operator()(const mayfly::app::RunOptions& options) const { return mayfly::app::run(options); }
  int operator()(const mayfly::app::CheckOptions& options) const { return mayfly::app::check(options); }
  int operator()(const mayfly::app::TestOptions& options) const { return mayfly::app::test(options); }
  int operator()(const mayfly::app::BenchOptions& options) const { return mayfly::app::bench(options); }
  int operator()(const mayfly::app::GuardOptions& options) const { return mayfly::app::guard(options); }
  int operator()(const mayfly::app::DoctorOptions&) const { return mayfly::app::doctor(); }
};

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto command = mayfly::app::parse_arguments(argc, argv);
    return command ? std::visit(Runner{}, *command) : command.error();
  } catch (const std::exception& failure) {
    // Rooms return their failures; what is left is memory that the machine does not have.
    std::fprintf(stderr, "mayfly: %s\n", failure.what());
    return mayfly::app::kMachineOrRobot;
  }
}
