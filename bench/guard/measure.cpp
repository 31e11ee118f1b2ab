#include "bench/guard/measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "controller/guard/guard.hpp"

namespace mayfly::bench {
namespace {

constexpr Time kPeriod = std::chrono::milliseconds(10);
constexpr float kSpeed = 2.0F;
constexpr float kRoom = 8.0F;  // m³ a robot

// s, of this thread: what others do meanwhile does not count.
double cpu_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Robots that obey at once.
class Obedient final : public Hal {
 public:
  explicit Obedient(std::vector<glm::vec3> places) : at(std::move(places)), velocity(at.size()) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      infos_.push_back({"robot_" + std::to_string(i), "none"});
    }
  }
  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return "obedient"; }

  void fill(Time now, const StateColumns& to) const noexcept {
    for (std::size_t i = 0; i < at.size(); ++i) {
      to.x[i] = at[i].x;
      to.y[i] = at[i].y;
      to.z[i] = at[i].z;
      to.vx[i] = velocity[i].x;
      to.vy[i] = velocity[i].y;
      to.vz[i] = velocity[i].z;
      to.stamp[i] = now;
      to.valid[i] = 1;
      if (!to.telemetry.empty()) {
        to.telemetry[i] = {now, 0.9F, 1.0F, true};
      }
    }
  }
  void move() noexcept {
    for (std::size_t i = 0; i < at.size(); ++i) {
      at[i] += static_cast<float>(to_seconds(kPeriod)) * velocity[i];
    }
  }

  std::vector<glm::vec3> at, velocity;

 private:
  Result<void> do_configure() override { return {}; }
  Result<void> do_activate(Time) override { return {}; }
  Result<void> do_deactivate(Time) override { return {}; }
  HalResult do_read(Time now, const StateColumns& to) noexcept override {
    fill(now, to);
    return {};
  }
  HalResult do_write(Time, const CommandColumns& c) noexcept override {
    for (std::size_t i = 0; i < at.size(); ++i) {
      velocity[i] = c.kind[i] == CommandKind::kVelocity ? glm::vec3(c.vx[i], c.vy[i], c.vz[i]) : glm::vec3(0);
    }
    return {};
  }

  std::vector<RobotInfo> infos_;
};

// On a lattice, with room for everybody.
std::vector<glm::vec3> lattice(std::size_t robots, float side) {
  const auto across = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(robots))));
  const float step = side / static_cast<float>(across + 1);
  std::vector<glm::vec3> places;
  for (std::size_t i = 0; i < robots; ++i) {
    places.push_back(step * glm::vec3(1 + i % across, 1 + i / across % across, 1 + i / across / across));
  }
  return places;
}

GuardConfig config_of(std::size_t robots, float side) {
  GuardConfig config;
  config.period = config.governor.period = config.estimator.period = config.estimator.pose_period = kPeriod;
  config.governor.fence = {{0, 0, 0}, {side, side, side}};
  GovernorGroup group;
  group.count = robots;
  group.limits.speed = kSpeed;
  group.limits.acceleration = group.limits.braking = 4.0F;
  group.limits.radius = 0.1F;
  group.limits.tube = 0.05F;
  group.limits.follows = Follows::kAtOnce;
  config.governor.groups = {group};
  config.estimator.most_age = 10 * kPeriod;
  config.estimator.most_ahead = kPeriod;
  config.estimator.robots.assign(robots, {kSpeed, 4.0F, 0.0F});
  config.life_cycle.robots = robots;
  config.most_plan_age = config.command_life = config.governor.command_life = 5 * kPeriod;
  return config;
}

// The guard's parts once more, each by itself, on what the guard sees: what they cost there is what they cost
// in it.
struct Parts {
  Estimator estimator;
  Governor governor;
  Monitor monitor;
};

struct Samples {
  std::vector<double> sense, act, estimator, governor, monitor;

  static double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }
};

class Trial {
 public:
  static Result<Samples> run(std::size_t robots, int ticks) {
    Trial trial(robots);
    auto guard = Guard::create(trial.config_, trial.robots_);
    auto estimator = Estimator::create(trial.config_.estimator);
    auto governor = Governor::make(trial.config_.governor);
    if (!guard || !estimator || !governor) {
      return fail(guard ? (estimator ? governor.error() : estimator.error()) : guard.error());
    }
    const GuardConfig& c = trial.config_;
    Parts parts{std::move(*estimator), std::move(*governor),
                Monitor({c.period, c.command_life, c.tick_budget, c.governor.fence, c.governor.half_spaces,
                         c.governor.groups, c.hooks})};
    Samples samples;
    for (int tick = 0; tick < ticks; ++tick) {
      trial.tick(**guard, parts, samples);
    }
    return samples;
  }

 private:
  explicit Trial(std::size_t robots)
      : side_(std::cbrt(kRoom * static_cast<float>(robots))),
        config_(config_of(robots, side_)),
        robots_(lattice(robots, side_)),
        goals_(robots_.at),
        kind_(robots, CommandKind::kVelocity),
        governed_kind_(robots),
        symptoms_(robots),
        states_(robots, RobotState::kFlying),
        severities_(robots, Severity::kNone),
        ours_(robots, 1) {
    for (std::vector<float>* column : {&vx_, &vy_, &vz_, &governed_x_, &governed_y_, &governed_z_}) {
      column->resize(robots);
    }
    static_cast<void>(robots_.configure());
    static_cast<void>(robots_.activate(now_));
  }

  // Each flies to one place of chance after the other.
  void wish() {
    std::uniform_real_distribution<float> inside(0.05F * side_, 0.95F * side_);
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      if (glm::distance(goals_[i], robots_.at[i]) < 0.3F) {
        goals_[i] = {inside(random_), inside(random_), inside(random_)};
      }
      const glm::vec3 way = kSpeed * glm::normalize(goals_[i] - robots_.at[i] + glm::vec3(1e-6F));
      vx_[i] = way.x;
      vy_[i] = way.y;
      vz_[i] = way.z;
    }
  }

  void tick(Guard& guard, Parts& parts, Samples& samples) {
    now_ += kPeriod;
    robots_.move();
    wish();
    const CommandColumns wish{kind_, vx_, vy_, vz_, now_ + 3 * kPeriod, ++sequence_};
    robots_.fill(now_, parts.estimator.inbox());
    measure(samples.estimator, [&] { parts.estimator.update(now_); });
    const EstimateColumns e = parts.estimator.estimate();
    const GovernedColumns governed{governed_kind_, governed_x_, governed_y_, governed_z_, symptoms_};
    measure(samples.governor, [&] {
      parts.governor.govern(now_, {e.x, e.y, e.z, e.vx, e.vy, e.vz, e.known}, {vx_, vy_, vz_}, governed);
    });
    const CommandColumns sent{governed_kind_, governed_x_,        governed_y_,
                              governed_z_,    now_ + 5 * kPeriod, sequence_};
    const TickOutcome outcome{now_, sent, e, states_, severities_, ours_, symptoms_, false};
    measure(samples.monitor, [&] { parts.monitor.check(outcome); });
    parts.estimator.sent(now_, sent);
    measure(samples.sense, [&] { guard.sense(now_); });
    measure(samples.act, [&] { guard.act(now_, wish); });
  }

  template <class Work>
  static void measure(std::vector<double>& samples, const Work& work) {
    const double began = cpu_seconds();
    work();
    samples.push_back(cpu_seconds() - began);
  }

  float side_;
  GuardConfig config_;
  Obedient robots_;
  std::vector<glm::vec3> goals_;
  std::vector<CommandKind> kind_, governed_kind_;
  std::vector<float> vx_, vy_, vz_, governed_x_, governed_y_, governed_z_;
  std::vector<Symptoms> symptoms_;
  std::vector<RobotState> states_;
  std::vector<Severity> severities_;
  std::vector<std::uint8_t> ours_;
  std::mt19937 random_{7};
  Time now_{std::chrono::seconds(1)};
  std::uint64_t sequence_ = 0;
};

void add_rows(Report& report, std::size_t robots, const Samples& samples) {
  const std::string count = std::to_string(robots);
  const auto row = [&](const std::string& key, const std::string& what, double seconds) {
    report.rows.push_back({.key = key + "_" + count, .what = what, .value = 1e6 * seconds, .unit = "us"});
  };
  const double sense = Samples::median(samples.sense);
  const double act = Samples::median(samples.act);
  const double estimator = Samples::median(samples.estimator);
  const double governor = Samples::median(samples.governor);
  const double monitor = Samples::median(samples.monitor);
  row("tick", count + " robots: sense and act, a tick", sense + act);
  row("estimator", "  of it, the estimator", estimator);
  row("governor", "  the governor", governor);
  row("monitor", "  the monitor", monitor);
  row("rest", "  the rest: life cycle, reactions, orders, black box",
      sense + act - estimator - governor - monitor);
}

}  // namespace

Result<Report> measure_guard(const GuardPlan& plan) {
  Report report{
      .bench = "guard", .title = "A tick of the guard (CPU time, medians)", .rows = {}, .curves = {}};
  const auto start = std::chrono::steady_clock::now();
  double done = 0.0;
  for (const std::size_t robots : {std::max<std::size_t>(1, plan.most_agents / 10), plan.most_agents}) {
    const auto samples = Trial::run(robots, plan.ticks);
    if (!samples) {
      return fail(samples.error());
    }
    add_rows(report, robots, *samples);
    done += 0.5;
    if (plan.progress) {
      plan.progress("guard", done);
    }
  }
  report.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace mayfly::bench
