// One value handed from one thread to another without waiting: the newest wins, what was not collected is
// overwritten.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace mayfly {

// A triple buffer. One producer thread fills draft() and publishes it; one consumer thread collects and looks
// at latest(). Every call is wait-free and allocates nothing: give the constructor a value that already has
// its final size.
//
//   Mailbox<std::vector<float>> box(std::vector<float>(100));
//   box.draft()[0] = 1.0F;  box.publish();          // producer
//   if (box.collect()) { use(box.latest()); }       // consumer
//
// draft() holds an old value after publish(), not the one just published: fill all of it.
template <class T>
class Mailbox {
 public:
  explicit Mailbox(const T& initial = T()) : slots_{initial, initial, initial} {}
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  // Producer only.
  T& draft() noexcept { return slots_[producer_]; }
  void publish() noexcept {
    producer_ =
        middle_.exchange(static_cast<std::uint8_t>(producer_ | kFresh), std::memory_order_acq_rel) & kSlot;
  }

  // Consumer only. True where something newer than latest() had been published; latest() is that from now on.
  bool collect() noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) {
      return false;
    }
    consumer_ = middle_.exchange(consumer_, std::memory_order_acq_rel) & kSlot;
    return true;
  }
  // The initial value until the first collect() that returned true.
  const T& latest() const noexcept { return slots_[consumer_]; }

 private:
  static constexpr std::uint8_t kSlot = 3;
  static constexpr std::uint8_t kFresh = 4;
  static constexpr std::size_t kCacheLine = 64;

  std::array<T, 3> slots_;
  // Each on its own cache line, so that neither thread slows the other down.
  alignas(kCacheLine) std::uint8_t producer_ = 0;
  alignas(kCacheLine) std::atomic<std::uint8_t> middle_{1};
  alignas(kCacheLine) std::uint8_t consumer_ = 2;
};

}  // namespace mayfly
