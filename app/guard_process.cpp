#include "app/guard_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <system_error>
#include <utility>
#include <vector>

#include "app/black_box_file.hpp"
#include "simulate/robots.hpp"

namespace mayfly::app {
namespace {

constexpr Time kLook = std::chrono::milliseconds(50);
// From letting go of the robots to the end of the process, in which it writes its report.
constexpr Time kMostGoodbye = std::chrono::seconds(5);

// What the guard needs of the command line to load the same as we did.
std::vector<std::string> guard_arguments(const RunOptions& options, const std::string& scenario, int segment,
                                         int planner) {
  std::vector<std::string> words{"mayfly",
                                 "guard",
                                 options.scenario.string(),
                                 "--segment",
                                 std::to_string(segment),
                                 "--planner",
                                 std::to_string(planner)};
  if (!options.hal.empty()) {
    words.insert(words.end(), {"--hal", options.hal});
  }
  for (const std::string& text : options.sets) {
    words.insert(words.end(), {"--set", text});
  }
  if (!options.guard_report.empty()) {
    words.insert(words.end(), {"--guard-report", options.guard_report.string()});
  }
  words.insert(words.end(), {"--black-box", black_box_file(options.record, scenario).string()});
  if (options.verbose) {
    words.emplace_back("--verbose");
  }
  return words;
}

// A descriptor that the child inherits, until it goes out of scope here.
class Inherited {
 public:
  explicit Inherited(int descriptor) : descriptor_(::fcntl(descriptor, F_DUPFD, 0)) {}
  Inherited(const Inherited&) = delete;
  Inherited& operator=(const Inherited&) = delete;
  ~Inherited() { ::close(descriptor_); }
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

Result<pid_t> spawn(std::vector<std::string> words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_t process = -1;
  const int failed = ::posix_spawn(&process, "/proc/self/exe", nullptr, nullptr, arguments.data(), environ);
  if (failed != 0) {
    return fail(Cause::kEnvironment,
                "the guard's process cannot be started: " + std::generic_category().message(failed));
  }
  return process;
}

}  // namespace

Result<std::unique_ptr<GuardProcess>> GuardProcess::start(const RunOptions& options, const Scenario& scenario,
                                                          const RealtimeClock& clock,
                                                          const StopRequest& asked_to_stop) {
  link::ShmHalConfig config;
  config.robots = simulate::robot_names(scenario);
  config.period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  config.asked_to_stop = &asked_to_stop;
  auto segment = link::Segment::create(link::roster_of(config.robots), clock.start());
  if (!segment) {
    return fail(std::move(segment.error()));
  }
  auto end = link::PlannerEnd::make(std::move(*segment));
  if (!end) {
    return fail(std::move(end.error()));
  }
  auto self = link::ProcessWatch::of(::getpid());
  if (!self) {
    return fail(std::move(self.error()));
  }
  const Inherited shared(end->segment().descriptor());
  const Inherited planner(self->descriptor());
  auto process = spawn(guard_arguments(options, scenario.name, shared.get(), planner.get()));
  if (!process) {
    return fail(std::move(process.error()));
  }
  auto watch = link::ProcessWatch::of(*process);
  if (!watch) {
    return fail(std::move(watch.error()));
  }
  return std::unique_ptr<GuardProcess>(
      new GuardProcess(std::move(config), std::move(*end), std::move(*watch), *process));
}

GuardProcess::GuardProcess(link::ShmHalConfig config, link::PlannerEnd end, link::ProcessWatch watch,
                           pid_t process)
    : process_watch_(std::move(watch)),
      process_(process),
      hal_(std::move(config), std::move(end), process_watch_),
      watcher_([this] { this->watch(); }) {}

GuardProcess::~GuardProcess() {
  leaving_.store(true, std::memory_order_relaxed);
  watcher_.join();
}

void GuardProcess::watch() noexcept {
  while (!leaving_.load(std::memory_order_relaxed)) {
    if (process_watch_.has_ended(kLook)) {
      hal_.guard_ended();
      return;
    }
  }
}

std::string GuardProcess::how_it_failed() {
  int status = 0;
  if (!process_watch_.has_ended(kMostGoodbye) || ::waitpid(process_, &status, WNOHANG) != process_) {
    return "the guard has not ended yet";
  }
  if (WIFSIGNALED(status)) {
    return fmt::format("the guard was killed by signal {}", WTERMSIG(status));
  }
  if (WEXITSTATUS(status) != 0) {
    return fmt::format("the guard ended with status {}", WEXITSTATUS(status));
  }
  return hal_.lost() ? "the guard ended before the flight did" : "";
}

}  // namespace mayfly::app
