#include "app/run_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "app/black_box_file.hpp"
#include "app/exit_code.hpp"
#include "app/flight_line.hpp"
#include "app/guard_process.hpp"
#include "app/log.hpp"
#include "app/outputs.hpp"
#include "app/progress_line.hpp"
#include "app/signals.hpp"
#include "app/summary_table.hpp"
#include "app/wiring.hpp"
#include "controller/flight/prepare.hpp"
#include "controller/scenario/load.hpp"
#include "simulate/robots.hpp"
#include "simulate/sabotage.hpp"

namespace mayfly::app {
namespace {

int refuse(std::span<const Error> errors) {
  print_errors(errors);
  return exit_code_of(errors.front());
}
int refuse(const Error& error) {
  return refuse(std::span(&error, 1));
}

ScenarioResult load(const RunOptions& options) {
  auto scenario = load_scenario(options.scenario, options.overrides);
  if (scenario && !options.hal.empty()) {
    if (auto chosen = choose_hal(*scenario, options.hal); !chosen) {
      return tl::unexpected(std::vector{std::move(chosen.error())});
    }
  }
  return scenario;
}

void announce(const RunOptions& options, const Scenario& scenario, const Engine& engine, std::size_t agents) {
  if (options.quiet) {
    return;
  }
  fmt::print("flying {}: {} agent{} for {:.4g} s, {} engine, {}; Ctrl-C stops the swarm\n", scenario.name,
             agents, agents == 1 ? "" : "s", scenario.duration, engine.name(),
             options.fast ? "as fast as it goes" : "in real time");
  std::fflush(stdout);
}

int exit_code_of(const Summary& summary, int signal_number) {
  if (summary.stopped_by_user && signal_number != 0) {
    return 128 + signal_number;
  }
  const bool held = std::all_of(summary.expect.begin(), summary.expect.end(),
                                [](const ExpectationResult& result) { return result.pass; });
  return held ? kSuccess : kExpectationBroken;
}

GuardPlace guard_of(const RunOptions& options, const Scenario& scenario) {
  return options.guard.value_or(scenario.control.guard);
}

// The robots, in this process or behind a guard's.
struct OwnRobots {
  simulate::Robots simulated;
  std::unique_ptr<GuardProcess> guard;
};

Result<OwnRobots> own_robots(const RunOptions& options, const Scenario& scenario, const Prepared& ready,
                             Clock& clock, const StopRequest& stop) {
  OwnRobots robots;
  if (guard_of(options, scenario) == GuardPlace::kInline) {
    robots.simulated = simulate::make_robots(scenario, ready.places, clock);
    return robots;
  }
  auto guard = GuardProcess::start(options, scenario, dynamic_cast<const RealtimeClock&>(clock), stop);
  if (!guard) {
    return fail(std::move(guard.error()));
  }
  robots.guard = std::move(*guard);
  return robots;
}

// From here on everything is ready, and Ctrl-C stops the swarm instead of the program.
int fly_and_tell(const RunOptions& options, const Scenario& scenario, const Prepared& ready,
                 ProgressLine& line) {
  const std::size_t agents = ready.models.agents();
  auto engine = make_engine(options.engine, options.threads, ready, 1.0F / scenario.control.rate);
  if (!engine) {
    return refuse(engine.error());
  }
  const StopSignals signals;
  auto outputs = Outputs::open(options, scenario, agents);
  if (!outputs) {
    return refuse(outputs.error());
  }
  const auto clock = make_clock(options.fast);
  auto robots = own_robots(options, scenario, ready, *clock, signals.stop());
  if (!robots) {
    return refuse(robots.error());
  }
  const StopRequest& stop = robots->guard ? robots->guard->stop() : signals.stop();
  Hal& hal = robots->guard ? static_cast<Hal&>(robots->guard->port()) : *robots->simulated.hal;
  const simulate::Sabotage sabotage(scenario, **engine, *clock, &stop);
  FlightGauge gauge;
  announce(options, scenario, **engine, agents);
  auto summary = [&] {
    const FlightLine flight_line(line, gauge, scenario.duration, agents);
    return fly({
        .scenario = scenario,
        .world = ready.world,
        .engine = sabotage.engine(),
        .hal = hal,
        .truth = robots->simulated.truth.get(),
        .clock = sabotage.clock(),
        .observers = outputs->observers(),
        .stop = sabotage.stop(),
        .gauge = &gauge,
        .guard = robots->guard ? &robots->guard->port() : nullptr,
        .between = [&](GuardPort& guard) { return sabotage.before(guard); },
        .exchange = robots->simulated.exchange.get(),
        // Another process keeps its own.
        .keep_tape =
            [&](const BlackBoxTape& tape) {
              write_black_box(black_box_file(options.record, scenario.name), robots->simulated.hal->robots(),
                              tape);
            },
    });
  }();
  const std::string guard_failed = robots->guard ? robots->guard->how_it_failed() : "";
  if (!summary) {
    return refuse(summary.error());
  }
  summary->stopped_by_user = signals.stop().load() > 0;
  const auto unwritten = outputs->finish(scenario, *summary);
  if (!options.quiet) {
    fmt::print("{}", summary_table(*summary, !options.fast));
  }
  if (!unwritten.empty()) {
    return refuse(unwritten);
  }
  if (!guard_failed.empty()) {
    return refuse(Error{.cause = Cause::kDevice, .message = guard_failed});
  }
  return exit_code_of(*summary, signals.signal_number());
}

}  // namespace

int run(const RunOptions& options) {
  set_up_log(options.verbose);
  const auto scenario = load(options);
  if (!scenario) {
    return refuse(scenario.error());
  }
  if (options.fast && guard_of(options, *scenario) == GuardPlace::kProcess) {
    return refuse(Error{
        .message = "a guard in a process of its own flies in real time: two processes share no virtual clock",
        .found = options.guard ? "--fast with --guard process" : "--fast with 'control.guard: process'",
        .wanted = "one of the two",
        .suggestion = options.guard ? "" : "--guard inline"});
  }
  ProgressLine line(!options.quiet);
  const auto warn = [&line](const Error& warning) {
    line.clear();
    log_warning(to_string(warning));
  };
  const auto ready = prepare(
      *scenario,
      {.threads = options.threads, .in_real_time = !options.fast, .progress = line.stages(), .warn = warn});
  line.clear();
  if (!ready) {
    return refuse(ready.error());
  }
  const World& world = (*ready)->world;
  log_detail(fmt::format("world: {} cells, {} triangles", world.grid.size(), world.solid.triangle_count()));
  return fly_and_tell(options, *scenario, **ready, line);
}

}  // namespace mayfly::app
