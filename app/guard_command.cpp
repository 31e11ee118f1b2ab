#include "app/guard_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "app/black_box_file.hpp"
#include "app/exit_code.hpp"
#include "app/link_report.hpp"
#include "app/log.hpp"
#include "app/signals.hpp"
#include "app/wiring.hpp"
#include "controller/clock/realtime_clock.hpp"
#include "controller/flight/flight_guard.hpp"
#include "controller/flight/flight_rights.hpp"
#include "controller/flight/placement.hpp"
#include "controller/flight/roster.hpp"
#include "controller/link/guard_loop.hpp"
#include "controller/link/process_watch.hpp"
#include "controller/scenario/load.hpp"
#include "simulate/robots.hpp"

namespace mayfly::app {
namespace {

// A wish is good for so many control periods, whatever it says.
constexpr int kWishPeriods = 5;
constexpr Time kLook = std::chrono::milliseconds(50);
constexpr Time kNoEnd = std::chrono::hours(24 * 365);

// Whoever started the planner may have left files open to it, and so to us: none is held while robots fly.
void close_all_but(int one, int other) {
  const auto [low, high] = std::minmax(one, other);
  const auto close_between = [](int from, int to) {
    if (from <= to) {
      ::close_range(static_cast<unsigned>(from), static_cast<unsigned>(to), 0);
    }
  };
  close_between(STDERR_FILENO + 1, low - 1);
  close_between(std::max(STDERR_FILENO, low) + 1, high - 1);
  close_between(std::max(STDERR_FILENO, high) + 1, std::numeric_limits<int>::max());
}

int refuse(std::span<const Error> errors) {
  print_errors(errors);
  return exit_code_of(errors.front());
}
int refuse(const Error& error) {
  return refuse(std::span(&error, 1));
}

// Everything that is read from files; done before the planner is told that the guard is ready.
struct Loaded {
  Scenario scenario;
  std::optional<World> world;
  std::vector<glm::vec3> places;
};

tl::expected<std::unique_ptr<Loaded>, std::vector<Error>> load(const GuardOptions& options) {
  auto scenario = load_scenario(options.scenario, options.overrides);
  if (!scenario) {
    return tl::unexpected(std::move(scenario.error()));
  }
  if (!options.hal.empty()) {
    if (auto chosen = choose_hal(*scenario, options.hal); !chosen) {
      return tl::unexpected(std::vector{std::move(chosen.error())});
    }
  }
  // On the heap before anything points into it.
  auto loaded = std::make_unique<Loaded>();
  loaded->scenario = std::move(*scenario);
  auto world = build_world(loaded->scenario, 1, {}, {});
  if (!world) {
    return tl::unexpected(std::move(world.error()));
  }
  auto places = place_agents(loaded->scenario, *world);
  if (!places) {
    return tl::unexpected(std::move(places.error()));
  }
  loaded->world = std::move(*world);
  loaded->places = std::move(*places);
  return loaded;
}

// Sees the planner's end, in a thread of its own: the loop makes no system call.
class PlannerWatch {
 public:
  explicit PlannerWatch(const link::ProcessWatch& planner)
      : thread_([this, &planner] {
          while (!leaving_.load(std::memory_order_relaxed) && !gone_.load(std::memory_order_relaxed)) {
            gone_.store(planner.has_ended(kLook), std::memory_order_relaxed);
          }
        }) {}
  PlannerWatch(const PlannerWatch&) = delete;
  PlannerWatch& operator=(const PlannerWatch&) = delete;
  ~PlannerWatch() {
    leaving_.store(true, std::memory_order_relaxed);
    thread_.join();
  }
  const std::atomic<bool>& gone() const noexcept { return gone_; }

 private:
  std::atomic<bool> gone_{false};
  std::atomic<bool> leaving_{false};
  std::thread thread_;
};

// False where there is no planner any more, or it does not want to fly.
bool wait_for_take_off(const link::GuardEnd& end, const link::ProcessWatch& planner) {
  constexpr Time kOften = std::chrono::milliseconds(2);
  while (end.want() == link::Want::kWait) {
    if (planner.has_ended(kOften)) {
      return false;
    }
  }
  return end.want() == link::Want::kFly;
}

// After the flight, when there is time for files.
void keep_tape(const GuardOptions& options, const Hal& robots, Guard& guard) {
  const BlackBoxTape* tape = guard.black_box().sealed();
  if (tape != nullptr && !options.black_box.empty()) {
    write_black_box(options.black_box, robots.robots(), *tape);
  }
}

Result<link::LinkReport> fly(const GuardOptions& options, const Loaded& loaded, link::GuardEnd& end,
                             const simulate::Robots& simulated, Clock& clock,
                             const link::ProcessWatch& planner) {
  if (auto configured = simulated.hal->configure(); !configured) {
    return fail(std::move(configured.error()));
  }
  Motion motion(loaded.scenario);
  GuardConfig config = guard_config(loaded.scenario, *loaded.world, motion, clock);
  config.hooks.owns_commands = [&end] { return end.has_one_owner(); };
  config.exchange = simulated.exchange.get();
  Hal& robots = *simulated.hal;
  auto guard = Guard::create(std::move(config), robots);
  if (!guard) {
    return fail(std::move(guard.error()));
  }
  const auto rate = static_cast<double>(loaded.scenario.control.rate);
  const StopSignals signals(StopSignals::Of::kGuard);
  const PlannerWatch watch(planner);
  link::GuardLoop loop({**guard, end, clock, watch.gone(), signals.stop()});
  Executor executor(clock);
  Time began{0};
  Roster roster(loaded.scenario);
  (*guard)->set_present(roster.present());
  if (auto added = executor.add_task("guard", rate,
                                     [&](const TickInfo& info) noexcept {
                                       const double flown_s = to_seconds(clock.now() - began);
                                       motion.set_time(flown_s);
                                       roster.set_time(flown_s);
                                       loop.tick(info);
                                     });
      !added) {
    return fail(std::move(added.error()));
  }
  const auto rights = FlightRights::take(loaded.scenario.control.realtime);
  if (!rights) {
    return fail(rights.error());
  }
  end.set_phase(link::Phase::kReady);
  if (!wait_for_take_off(end, planner)) {
    link::LinkReport report = loop.report();
    report.planner_died = end.want() != link::Want::kEnd;
    return report;
  }
  began = clock.now();
  if (auto activated = robots.activate(began); !activated) {
    return fail(std::move(activated.error()));
  }
  (*guard)->restart();
  end.set_phase(link::Phase::kActive);
  executor.set_realtime({rights->granted().priority, -1, true});
  const auto flown = executor.run(kNoEnd, loop.finished());
  end.set_phase(link::Phase::kEnding);
  if (auto deactivated = robots.deactivate(clock.now()); !deactivated) {
    return fail(std::move(deactivated.error()));
  }
  if (!flown) {
    return fail(flown.error());
  }
  keep_tape(options, robots, **guard);
  link::LinkReport report = loop.report();
  report.witness = executor.witness().oversleep();
  return report;
}

int tell(const GuardOptions& options, const link::LinkReport& report, Time epoch) {
  if (report.planner_died) {
    log_warning("guard: the planner has ended without a word; the robots rest and are let go");
  }
  if (!options.guard_report.empty()) {
    if (auto written = write_link_report(options.guard_report, report, epoch); !written) {
      return refuse(written.error());
    }
  }
  return kSuccess;
}

}  // namespace

int guard(const GuardOptions& options) {
  set_up_log(options.verbose);
  close_all_but(options.planner, options.segment);
  auto planner = link::ProcessWatch::adopt(options.planner);
  if (!planner) {
    return refuse(planner.error());
  }
  const auto loaded = load(options);
  if (!loaded) {
    return refuse(loaded.error());
  }
  const Scenario& scenario = (*loaded)->scenario;
  auto segment = link::Segment::attach(options.segment, link::roster_of(simulate::robot_names(scenario)));
  if (!segment) {
    return refuse(segment.error());
  }
  const Time epoch = segment->epoch();
  RealtimeClock clock(epoch);
  const Time period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  auto end = link::GuardEnd::make(std::move(*segment), kWishPeriods * period);
  if (!end) {
    return refuse(end.error());
  }
  const simulate::Robots robots =
      simulate::make_robots(scenario, (*loaded)->places, clock, sim_hal::Backend::kNative);
  const auto flown = fly(options, **loaded, *end, robots, clock, *planner);
  if (!flown) {
    return refuse(flown.error());
  }
  const int code = tell(options, *flown, epoch);
  end->set_phase(link::Phase::kEnded);
  return code;
}

}  // namespace mayfly::app
