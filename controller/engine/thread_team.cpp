#include "controller/engine/thread_team.hpp"

#include <algorithm>

namespace mayfly {
namespace {

// About 20 µs: longer than the pause between two loops of one tick, shorter than a tick.
constexpr int kSpins = 4000;
constexpr std::size_t kChunksPerThread = 16;

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
    workers_.emplace_back([this] { serve(); });
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
  // Large enough that taking one costs nothing, small enough that nobody waits long for the last.
  const std::size_t fair = count / (kChunksPerThread * size());
  chunk_ = std::max(grain, (fair + grain - 1) / grain * grain);
  next_.store(0, std::memory_order_relaxed);
  context_ = context;
  call_ = call;
  busy_.store(static_cast<std::uint32_t>(workers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  work();
  for (std::uint32_t left = busy_.load(std::memory_order_acquire); left != 0;
       left = busy_.load(std::memory_order_acquire)) {
    await_change(busy_, left);
  }
}

void ThreadTeam::serve() noexcept {
  std::uint32_t seen = 0;
  for (;;) {
    await_change(round_, seen);
    seen = round_.load(std::memory_order_acquire);
    if (ending_.load(std::memory_order_relaxed)) {
      return;
    }
    work();
    if (busy_.fetch_sub(1, std::memory_order_release) == 1) {
      busy_.notify_all();
    }
  }
}

void ThreadTeam::work() noexcept {
  for (;;) {
    const std::size_t first = next_.fetch_add(chunk_, std::memory_order_relaxed);
    if (first >= count_) {
      return;
    }
    call_(context_, first, std::min(first + chunk_, count_));
  }
}

}  // namespace mayfly
