// Values handed from one process to another through shared memory, without waiting and without trust.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace mayfly::link {

using Word = std::uint64_t;
using SharedWord = std::atomic<Word>;
static_assert(SharedWord::is_always_lock_free && sizeof(SharedWord) == sizeof(Word),
              "another process must be able to use it");

// A ring of slots, each a sequence word and a value; before them the number of the newest value. Numbers
// count from 1; value k lies in slot k % slots, whose sequence word is 2k where it is whole, odd while it is
// being written.
struct RingShape {
  std::size_t slots = 0;
  std::size_t bytes = 0;  // of a value

  static constexpr std::size_t kLine = 8;  // words in a cache line

  constexpr std::size_t value_words() const { return (bytes + sizeof(Word) - 1) / sizeof(Word); }
  // To whole cache lines, so that a reader of one slot does not slow the writer of the next.
  constexpr std::size_t slot_words() const { return (1 + value_words() + kLine - 1) / kLine * kLine; }
  constexpr std::size_t words() const { return kLine + slots * slot_words(); }
};

// The only writer of a ring. Reads nothing back from the memory: whoever else can write there can break what
// readers see, not this. Wait-free, allocates nothing.
//
// A writer that dies in the middle of publish() leaves the newest value whole: the slot in which it died is
// not the newest yet.
class RingWriter {
 public:
  RingWriter(std::span<SharedWord> memory, RingShape shape) : memory_(memory), shape_(shape) {}

  // `value` has at most shape.bytes; what it lacks stays as it was.
  void publish(std::span<const std::byte> value) noexcept {
    begin();
    std::size_t done = 0;
    for (std::size_t word = 0; done < value.size(); ++word) {
      put(word, value.subspan(done, std::min(sizeof(Word), value.size() - done)));
      done += sizeof(Word);
    }
    end();
  }

  // publish() in its steps, for tests of what a death between them leaves behind.
  void begin() noexcept {
    ++count_;
    slot_ =
        memory_.subspan(RingShape::kLine + count_ % shape_.slots * shape_.slot_words(), shape_.slot_words());
    slot_[0].store(2 * count_ - 1, std::memory_order_relaxed);
  }
  // Releases, so that whoever sees one word of a value sees that its slot is being written. (A fence would do
  // as well, but the thread sanitizer does not understand fences.)
  void put(std::size_t word, std::span<const std::byte> bytes) noexcept {
    Word value = 0;
    std::memcpy(&value, bytes.data(), bytes.size());
    slot_[1 + word].store(value, std::memory_order_release);
  }
  void end() noexcept {
    slot_[0].store(2 * count_, std::memory_order_release);
    memory_[0].store(count_, std::memory_order_release);
  }

 private:
  std::span<SharedWord> memory_;
  std::span<SharedWord> slot_;
  RingShape shape_;
  Word count_ = 0;
};

// Copies values out of a ring and shows the copies: what is looked at cannot change any more. Any number of
// readers; each is wait-free, writes nothing to the memory and allocates at construction only. No content of
// the memory makes it read outside, loop or show a value that is not whole.
class RingReader {
 public:
  RingReader(std::span<SharedWord> memory, RingShape shape)
      : memory_(memory), shape_(shape), latest_(shape.bytes), copy_(shape.bytes) {}

  // The newest value, if it is newer than latest(). False also where the writer is faster than the copying:
  // then the next call may have more luck.
  bool collect() noexcept {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const Word newest = memory_[0].load(std::memory_order_acquire);
      if (newest <= seen_) {
        return false;
      }
      if (copy(newest)) {
        seen_ = newest;
        return true;
      }
      ++torn_;
    }
    return false;
  }

  // The next one in order, for a ring of events; what was overwritten before it was collected is counted.
  // Use either this or collect().
  bool collect_next() noexcept {
    const Word newest = memory_[0].load(std::memory_order_acquire);
    if (newest <= seen_) {
      return false;
    }
    if (newest - seen_ > shape_.slots) {
      lost_ += newest - seen_ - shape_.slots;
      seen_ = newest - shape_.slots;
    }
    const bool whole = copy(++seen_);
    lost_ += whole ? 0U : 1U;
    return whole;
  }

  // The private copy of the last value that was collected; zeros before. Aligned for any number.
  std::span<std::byte> latest() noexcept { return latest_; }
  Word number() const noexcept { return seen_; }
  std::uint64_t torn() const noexcept { return torn_; }
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  static constexpr int kAttempts = 3;

  bool copy(Word number) noexcept {
    const std::span<SharedWord> slot =
        memory_.subspan(RingShape::kLine + number % shape_.slots * shape_.slot_words(), shape_.slot_words());
    if (slot[0].load(std::memory_order_acquire) != 2 * number) {
      return false;
    }
    for (std::size_t done = 0, word = 1; done < copy_.size(); done += sizeof(Word), ++word) {
      const Word value = slot[word].load(std::memory_order_acquire);
      std::memcpy(copy_.data() + done, &value, std::min(sizeof(Word), copy_.size() - done));
    }
    if (slot[0].load(std::memory_order_relaxed) != 2 * number) {
      return false;
    }
    std::swap(latest_, copy_);
    return true;
  }

  std::span<SharedWord> memory_;
  RingShape shape_;
  std::vector<std::byte> latest_, copy_;
  Word seen_ = 0;
  std::uint64_t torn_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace mayfly::link
