#include "record/path_sampler.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace mayfly::record {
namespace {

constexpr glm::vec3 kNowhere(std::numeric_limits<float>::quiet_NaN());

}  // namespace

PathSampler::PathSampler(std::size_t agents)
    : agents_(agents),
      paths_(std::min(agents, kMaxPaths)),
      positions_((kMaxRows + 1) * paths_),
      times_(kMaxRows + 1),
      order_(kMaxRows),
      scratch_(kMaxRows) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
}

void PathSampler::on_tick(const TickView& view) noexcept {
  store(latest_slot_, view);
  if (seen_++ % stride_ != 0) {
    return;
  }
  if (count_ == kMaxRows) {
    thin_out();
    if ((seen_ - 1) % stride_ != 0) {
      return;
    }
  }
  store(order_[count_++], view);
}

void PathSampler::store(std::size_t slot, const TickView& view) noexcept {
  times_[slot] = to_seconds(view.time);
  glm::vec3* to = positions_.data() + slot * paths_;
  for (std::size_t path = 0; path < paths_; ++path) {
    const std::size_t agent = agent_of(path);
    to[path] = view.is_there(agent) ? glm::vec3(view.x[agent], view.y[agent], view.z[agent]) : kNowhere;
  }
}

void PathSampler::thin_out() noexcept {
  // Even rows stay, in front; the slots of the odd ones become free behind them.
  for (std::size_t row = 0; row < kMaxRows; ++row) {
    scratch_[row % 2 == 0 ? row / 2 : kMaxRows / 2 + row / 2] = order_[row];
  }
  order_.swap(scratch_);
  count_ = kMaxRows / 2;
  stride_ *= 2;
}

std::vector<PathSampler::Row> PathSampler::rows() const {
  std::vector<Row> rows;
  const auto add = [&](std::size_t slot) {
    rows.push_back({times_[slot], std::span(positions_).subspan(slot * paths_, paths_)});
  };
  std::for_each_n(order_.begin(), count_, add);
  if (count_ > 0 && times_[order_[count_ - 1]] < times_[latest_slot_]) {
    add(latest_slot_);
  }
  return rows;
}

}  // namespace mayfly::record
