#include "controller/guard/black_box.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

std::size_t frames_for(const BlackBoxConfig& config, Time period, std::size_t robots) {
  const double wanted = std::ceil(config.seconds / std::max(to_seconds(period), 1e-6));
  // Two tapes.
  const std::size_t frame_bytes = 2 * (sizeof(BlackBoxFrame) + robots * sizeof(BlackBoxRow));
  const std::size_t fit = config.most_bytes / frame_bytes;
  return static_cast<std::size_t>(std::max(1.0, std::min(wanted, static_cast<double>(fit))));
}

}  // namespace

std::size_t BlackBoxTape::next() noexcept {
  if (size_ < frames_.size()) {
    return at(size_++);
  }
  const std::size_t oldest = first_;
  first_ = (first_ + 1) % frames_.size();
  return oldest;
}

BlackBox::BlackBox(const BlackBoxConfig& config, Time period, std::size_t robots) {
  const std::size_t frames = frames_for(config, period, robots);
  tapes_.emplace_back(frames, robots);
  tapes_.emplace_back(frames, robots);
}

void BlackBox::keep(const Tick& tick) noexcept {
  BlackBoxTape& tape = tapes_[running_];
  const std::size_t at = tape.next();
  const TickOutcome& o = tick.outcome;
  tape.frames_[at] = {o.now, o.commands.sequence, tick.everybody, tick.held};
  for (std::size_t i = 0; i < tape.robots_; ++i) {
    tape.rows_[at * tape.robots_ + i] = {
        o.estimate.x[i],  o.estimate.y[i],   o.estimate.z[i],    o.estimate.vx[i],  o.estimate.vy[i],
        o.estimate.vz[i], tick.wish.vx()[i], tick.wish.vy()[i],  tick.wish.vz()[i], o.commands.vx[i],
        o.commands.vy[i], o.commands.vz[i],  tick.symptoms[i],   tick.wish.kind(i), o.commands.kind[i],
        o.severities[i],  o.states[i],       o.estimate.known[i]};
  }
}

bool BlackBox::seal() noexcept {
  ++incidents_;
  if (is_sealed_.load(std::memory_order_acquire)) {
    return false;
  }
  running_ = 1 - running_;
  tapes_[running_].first_ = tapes_[running_].size_ = 0;
  is_sealed_.store(true, std::memory_order_release);
  return true;
}

const BlackBoxTape* BlackBox::sealed() const noexcept {
  return is_sealed_.load(std::memory_order_acquire) ? &tapes_[1 - running_] : nullptr;
}

void BlackBox::release() noexcept {
  is_sealed_.store(false, std::memory_order_release);
}

}  // namespace mayfly
