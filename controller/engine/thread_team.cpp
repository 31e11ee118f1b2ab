#include "controller/engine/thread_team.hpp"

#include <algorithm>

namespace mayfly {
namespace {

// About 20 µs: longer than the pause between two loops of one tick, shorter than a tick.
constexpr int kSpins = 4000;

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Returns when `value` is no longer `old`.
void await_change(const std::atomic<std::uint32_t>& value, std::uint32_t old) {
  for (int spin = 0; spin < kSpins; ++spin) {
    if (value.load(std::memory_order_acquire) != old) {
      return;
    }
    relax();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(int threads) {
  const auto helpers = static_cast<std::size_t>(std::max(threads, 1) - 1);
  workers_.reserve(helpers);
  for (std::size_t worker = 0; worker < helpers; ++worker) {
    workers_.emplace_back([this, worker] { serve(worker); });
  }
}

ThreadTeam::~ThreadTeam() {
  ending_.store(true, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& worker : workers_) {
    worker.join();
  }
}

void ThreadTeam::run(std::size_t count, std::size_t grain, void* context, Call call) noexcept {
  count_ = count;
  grain_ = grain;
  context_ = context;
  call_ = call;
  busy_.store(static_cast<std::uint32_t>(workers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  do_share(workers_.size());
  for (std::uint32_t left = busy_.load(std::memory_order_acquire); left != 0;
       left = busy_.load(std::memory_order_acquire)) {
    await_change(busy_, left);
  }
}

void ThreadTeam::serve(std::size_t worker) noexcept {
  std::uint32_t seen = 0;
  for (;;) {
    await_change(round_, seen);
    seen = round_.load(std::memory_order_acquire);
    if (ending_.load(std::memory_order_relaxed)) {
      return;
    }
    do_share(worker);
    if (busy_.fetch_sub(1, std::memory_order_release) == 1) {
      busy_.notify_all();
    }
  }
}

void ThreadTeam::do_share(std::size_t share) const noexcept {
  const std::size_t shares = workers_.size() + 1;
  const std::size_t grains = (count_ + grain_ - 1) / grain_;
  const std::size_t first = std::min(count_, grains * share / shares * grain_);
  const std::size_t last = std::min(count_, grains * (share + 1) / shares * grain_);
  if (first < last) {
    call_(context_, first, last);
  }
}

}  // namespace mayfly
