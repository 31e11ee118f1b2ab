#include "tests/sim/guard_process/two_processes.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

namespace mayfly::test {
namespace {

constexpr std::size_t kAgents = 12;

constexpr auto kRestless = R"(mayfly: 1
name: restless
seed: 3
duration: 600
world: {bounds: {min: [0, 0, 0], max: [30, 30, 12]}, cell: 1.0, goals: {far: {box: {min: [24, 24, 2], max: [28, 28, 10]}}}}
swarms:
  - name: flies
    count: 12
    start: {box: {min: [4, 4, 0.5], max: [16, 16, 2]}}
    goal: far
    noise: {kind: curl, scale: 2.0, gain: 0.3}
    cruise_speed: 0.3
    limits: {speed: 0.4, acceleration: 20, separation: 0.2}
    robots: sim
control: {rate: 200}
hal: {sim: {kind: sim}}
)";

// A process that has ended and was not waited for still has a number.
bool lives(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  stat >> number >> name >> state;
  return stat && state != "Z";
}

std::vector<std::string> words(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"run",
                               write_restless_scenario(folder),
                               "--guard",
                               "process",
                               "--guard-report",
                               folder.file("guard.json"),
                               "--summary",
                               folder.file("summary.json")};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

}  // namespace

std::string write_restless_scenario(const TemporaryFolder& folder) {
  std::ofstream(folder.file("mayfly.project")) << "";
  std::ofstream(folder.file("restless.yaml")) << kRestless;
  return folder.file("restless.yaml");
}

Time monotonic_now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

TwoProcesses::TwoProcesses(const std::vector<std::string>& arguments) : planner_(words(folder_, arguments)) {}

bool TwoProcesses::fly() {
  if (!planner_.read_until("Ctrl-C stops the swarm")) {
    return false;
  }
  // The segment has no name in any folder: it is found where the planner has it open.
  const std::filesystem::path open = "/proc/" + std::to_string(planner()) + "/fd";
  for (const auto& entry : std::filesystem::directory_iterator(open)) {
    std::error_code gone;
    if (std::filesystem::read_symlink(entry.path(), gone).string().find("memfd:mayfly") ==
        std::string::npos) {
      continue;
    }
    std::vector<RobotInfo> robots;
    for (std::size_t robot = 0; robot < kAgents; ++robot) {
      robots.push_back({"flies_" + std::to_string(robot), "sim"});
    }
    auto segment =
        link::Segment::attach(::open(entry.path().c_str(), O_RDWR | O_CLOEXEC), link::roster_of(robots));
    if (segment) {
      segment_.emplace(std::move(*segment));
      break;
    }
  }
  return segment_ && wait_for_beats(0);
}

bool TwoProcesses::wait_for_beats(std::uint64_t beats) {
  const auto active = static_cast<link::Word>(link::Phase::kActive);
  while (header().phase.load() < active && lives(planner())) {
    std::this_thread::yield();
  }
  const link::Word wanted = header().planner_beat.load() + beats;
  while (header().planner_beat.load() < wanted && lives(planner())) {
    std::this_thread::yield();
  }
  return header().phase.load() == active;
}

int TwoProcesses::segment_descriptor() const {
  return ::fcntl(segment_->descriptor(), F_DUPFD, 0);
}

pid_t TwoProcesses::planner() const {
  return planner_.id();
}
pid_t TwoProcesses::guard() const {
  return static_cast<pid_t>(header().guard.load() >> 32U);
}

void TwoProcesses::send_guard(int signal) const {
  ::kill(guard(), signal);
}

std::optional<TwoProcesses::Stopped> TwoProcesses::wait_for_stop(Time after) {
  link::RingReader views(segment_->view(), segment_->layout().view);
  while (lives(guard())) {
    if (!views.collect()) {
      std::this_thread::yield();
      continue;
    }
    link::Cutter cutter(views.latest().data());
    const link::ViewHead& head = *link::view_columns(cutter, kAgents).head;
    const Time still = segment_->epoch() + Time(head.still_ns);
    if (still > after) {
      return Stopped{still, Time(head.late_ns)};
    }
  }
  return std::nullopt;
}

nlohmann::json TwoProcesses::json(const std::string& file) const {
  return nlohmann::json::parse(text_of(folder_.file(file)), nullptr, false);
}

}  // namespace mayfly::test
