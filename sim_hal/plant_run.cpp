#include "sim_hal/plant_run.hpp"

#include <algorithm>
#include <limits>

#include "kernels/plants.h"

namespace mayfly::sim_hal {

namespace {

// After so long every plant that holds has stopped, as far as a float can tell.
constexpr double kSettlingTime = 60.0;  // s

void fill_limits(std::span<float> column, const std::vector<float>& limits) {
  if (limits.size() <= 1) {
    const float all = limits.empty() ? std::numeric_limits<float>::infinity() : limits.front();
    std::fill(column.begin(), column.end(), all);
    return;
  }
  std::copy(limits.begin(), limits.end(), column.begin());
}

}  // namespace

Result<PlantRun> PlantRun::create(const SimHalConfig& config) {
  const std::size_t robots = config.positions.size();
  auto chosen = make_stepper(config.backend, robots, {config.plant, config.time_constant, config.rate_hz});
  if (!chosen) {
    return fail(std::move(chosen.error()));
  }
  const PlantBlock block = chosen->stepper->block();
  for (std::size_t robot = 0; robot < robots; ++robot) {
    const glm::vec3 at = config.positions[robot];
    block.column(MF_PLANT_X, robots)[robot] = at.x;
    block.column(MF_PLANT_X + 1, robots)[robot] = at.y;
    block.column(MF_PLANT_X + 2, robots)[robot] = at.z;
  }
  fill_limits(block.column(MF_PLANT_MAX_SPEED, robots), config.max_speed);
  fill_limits(block.column(MF_PLANT_MAX_ACCELERATION, robots), config.max_acceleration);
  return PlantRun(std::move(*chosen), robots, config.rate_hz);
}

PlantRun::PlantRun(ChosenStepper chosen, std::size_t robots, double rate_hz)
    : stepper_(std::move(chosen.stepper)),
      note_(std::move(chosen.note)),
      robots_(robots),
      rate_hz_(rate_hz) {}

void PlantRun::resume(Time now) noexcept {
  if (!started_) {
    started_ = true;
    steps_ = StepClock(now, rate_hz_);
    return;
  }
  const auto most = static_cast<std::int64_t>(kSettlingTime * rate_hz_);
  done_ = std::max(done_, steps_.steps_at(now) - most);
  hold();
  advance(now);
}

std::string_view PlantRun::advance(Time now) noexcept {
  const std::int64_t until = steps_.steps_at(now);
  if (!holding_) {
    step(std::min(until, steps_.first_step_from(deadline_)) - done_);
  }
  if (done_ < until) {
    hold();
    step(until - done_);
  }
  return failure_;
}

bool PlantRun::step(std::int64_t count) noexcept {
  constexpr std::int64_t kMost = 1 << 20;  // one launch; the kernel counts in int
  while (count > 0 && failure_.empty()) {
    const std::int64_t now = std::min(count, kMost);
    failure_ = stepper_->step(static_cast<std::uint32_t>(now));
    count -= now;
    done_ += now;
  }
  return failure_.empty();
}

void PlantRun::command(const VelocityCommand& command) noexcept {
  if (!failure_.empty()) {
    return;
  }
  const PlantBlock block = stepper_->block();
  std::copy(command.x.begin(), command.x.end(), block.column(MF_PLANT_UX, robots_).begin());
  std::copy(command.y.begin(), command.y.end(), block.column(MF_PLANT_UX + 1, robots_).begin());
  std::copy(command.z.begin(), command.z.end(), block.column(MF_PLANT_UX + 2, robots_).begin());
  deadline_ = command.deadline;
  holding_ = false;
}

void PlantRun::hold() noexcept {
  if (holding_ || !failure_.empty()) {
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto column = stepper_->block().column(MF_PLANT_UX + axis, robots_);
    std::fill(column.begin(), column.end(), 0.0F);
  }
  holding_ = true;
}

PoseView PlantRun::view() noexcept {
  if (!failure_.empty()) {
    return {};
  }
  const PlantBlock block = stepper_->block();
  PoseView view{{}, steps_.time_of(done_), done_};
  for (int c = 0; c < 6; ++c) {
    view.columns[static_cast<std::size_t>(c)] = block.column(MF_PLANT_X + c, robots_);
  }
  return view;
}

}  // namespace mayfly::sim_hal
