#include "record/frame_ring.hpp"

#include <algorithm>
#include <array>

namespace mayfly::record {
namespace {

constexpr std::size_t kColumns = 9;

using Columns = std::array<std::span<const float> TickView::*, kColumns>;
constexpr Columns kFloatColumns{&TickView::x,         &TickView::y,         &TickView::z,
                                &TickView::vx,        &TickView::vy,        &TickView::vz,
                                &TickView::command_x, &TickView::command_y, &TickView::command_z};

}  // namespace

FrameRing::FrameRing(std::size_t frames, std::size_t agents) : frames_(frames) {
  for (Frame& frame : frames_) {
    frame.numbers_.resize(kColumns * agents);
    frame.kinds_.resize(agents);
    frame.valid_.resize(agents);
    frame.present_.resize(agents);
    for (std::size_t column = 0; column < kColumns; ++column) {
      frame.view.*kFloatColumns[column] = std::span(frame.numbers_).subspan(column * agents, agents);
    }
    frame.view.kind = frame.kinds_;
    frame.view.valid = frame.valid_;
  }
}

bool FrameRing::push(const TickView& view) noexcept {
  const std::size_t pushed = pushed_.load(std::memory_order_relaxed);
  if (pushed - popped_.load(std::memory_order_acquire) == frames_.size()) {
    ++lost_;
    return false;
  }
  Frame& frame = frames_[pushed % frames_.size()];
  float* to = frame.numbers_.data();
  for (const auto column : kFloatColumns) {
    to = std::copy((view.*column).begin(), (view.*column).end(), to);
  }
  std::copy(view.kind.begin(), view.kind.end(), frame.kinds_.begin());
  std::copy(view.valid.begin(), view.valid.end(), frame.valid_.begin());
  std::copy(view.present.begin(), view.present.end(), frame.present_.begin());
  frame.view.present = std::span(frame.present_).first(view.present.size());
  frame.view.tick = view.tick;
  frame.view.time = view.time;
  frame.lost_before = lost_;
  lost_ = 0;
  pushed_.store(pushed + 1, std::memory_order_release);
  return true;
}

const FrameRing::Frame* FrameRing::front() const noexcept {
  const std::size_t popped = popped_.load(std::memory_order_relaxed);
  return popped == pushed_.load(std::memory_order_acquire) ? nullptr : &frames_[popped % frames_.size()];
}

void FrameRing::pop() noexcept {
  popped_.store(popped_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

}  // namespace mayfly::record
