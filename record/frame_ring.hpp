// Frames on their way from the control thread to a writer: allocated once, handed over without waiting.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "controller/flight/observer.hpp"

namespace mayfly::record {

// One producer thread, one consumer thread. What does not fit is dropped and counted with the next frame that
// does.
class FrameRing {
 public:
  struct Frame {
    TickView view;                  // its columns lie in this frame
    std::uint64_t lost_before = 0;  // frames dropped just before this one

   private:
    friend class FrameRing;
    std::vector<float> numbers_;
    std::vector<CommandKind> kinds_;
    std::vector<std::uint8_t> valid_, present_;
  };

  FrameRing(std::size_t frames, std::size_t agents);

  // Producer: copies the frame. False where the ring was full.
  bool push(const TickView& view) noexcept;

  // Consumer: the oldest frame, or null; it stays until pop().
  const Frame* front() const noexcept;
  void pop() noexcept;

  // Frames dropped since the last one that was pushed. Only once the producer has stopped.
  std::uint64_t lost_at_end() const noexcept { return lost_; }

 private:
  std::vector<Frame> frames_;
  std::uint64_t lost_ = 0;
  alignas(64) std::atomic<std::size_t> pushed_{0};
  alignas(64) std::atomic<std::size_t> popped_{0};
};

}  // namespace mayfly::record
