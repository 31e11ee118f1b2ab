// A few threads that share one loop. They spin for a moment between loops and sleep when none comes, so that
// a tick makes no system call while the swarm flies at full speed and burns no processor while it idles.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <type_traits>
#include <vector>

namespace mayfly {

class ThreadTeam {
 public:
  // `threads` in all, the caller's included; at least 1.
  explicit ThreadTeam(int threads);
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ~ThreadTeam();

  std::size_t size() const { return workers_.size() + 1; }

  // Calls body(first, last) on disjoint ranges that cover [0, count), cut at multiples of `grain`; returns
  // when all are done. Which thread takes which range is chance. Not reentrant. The body must not throw.
  template <class Body>
  void for_ranges(std::size_t count, std::size_t grain, Body&& body) noexcept {
    using Plain = std::remove_reference_t<Body>;
    if (workers_.empty() || count <= grain) {
      if (count > 0) {
        body(std::size_t{0}, count);
      }
      return;
    }
    run(count, grain, &body, [](void* context, std::size_t first, std::size_t last) {
      (*static_cast<Plain*>(context))(first, last);
    });
  }

 private:
  using Call = void (*)(void* context, std::size_t first, std::size_t last);

  void run(std::size_t count, std::size_t grain, void* context, Call call) noexcept;
  void serve() noexcept;
  void work() noexcept;

  std::vector<std::thread> workers_;
  std::atomic<std::uint32_t> round_{0};
  std::atomic<std::uint32_t> busy_{0};
  std::atomic<bool> ending_{false};
  // The loop of this round.
  std::size_t count_ = 0;
  std::size_t chunk_ = 1;  // how much a thread takes at once
  std::atomic<std::size_t> next_{0};
  void* context_ = nullptr;
  Call call_ = nullptr;
};

}  // namespace mayfly
