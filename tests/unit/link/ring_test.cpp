#include "controller/link/shared_ring.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace mayfly::link {
namespace {

constexpr RingShape kShape{4, 8 * 20};
using Value = std::array<Word, 20>;

// The memory of a ring, all zeros at first as the system gives it.
struct Ring {
  explicit Ring(RingShape of = kShape) : shape(of), words(of.words()) {}
  RingWriter writer() { return {words, shape}; }
  RingReader reader() { return {words, shape}; }

  RingShape shape;
  std::vector<SharedWord> words;
};

Value filled(Word with) {
  Value value;
  value.fill(with);
  return value;
}
std::span<const std::byte> bytes(const Value& value) {
  return std::as_bytes(std::span(value));
}
Value shown(RingReader& reader) {
  Value value;
  std::memcpy(value.data(), reader.latest().data(), sizeof(value));
  return value;
}

TEST(SharedRing, ShowsNothingUntilSomethingIsPublished) {
  Ring ring;
  RingReader reader = ring.reader();
  EXPECT_FALSE(reader.collect());
  EXPECT_EQ(shown(reader), filled(0));
  RingWriter writer = ring.writer();
  writer.publish(bytes(filled(7)));
  EXPECT_TRUE(reader.collect());
  EXPECT_EQ(shown(reader), filled(7));
  EXPECT_FALSE(reader.collect());
  EXPECT_EQ(shown(reader), filled(7));
}

TEST(SharedRing, TheNewestWins) {
  Ring ring;
  RingWriter writer = ring.writer();
  RingReader reader = ring.reader();
  for (Word value = 1; value <= 9; ++value) {
    writer.publish(bytes(filled(value)));
  }
  EXPECT_TRUE(reader.collect());
  EXPECT_EQ(shown(reader), filled(9));
}

TEST(SharedRing, AValueOfAnOddNumberOfBytesKeepsAllOfThem) {
  Ring ring({4, 13});
  RingWriter writer = ring.writer();
  RingReader reader = ring.reader();
  const std::array<unsigned char, 13> value{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
  writer.publish(std::as_bytes(std::span(value)));
  ASSERT_TRUE(reader.collect());
  ASSERT_EQ(reader.latest().size(), value.size());
  EXPECT_EQ(std::memcmp(reader.latest().data(), value.data(), value.size()), 0);
}

// The writer dies after any number of steps of publish(), at any place of the ring: what was whole before is
// still shown, to readers that come later, too, and nothing else ever is.
TEST(SharedRing, AWriterThatDiesInMidWriteLeavesTheNewestWhole) {
  for (Word before = 0; before <= 9; ++before) {
    for (std::size_t steps = 0; steps <= 20; ++steps) {
      Ring ring;
      RingWriter writer = ring.writer();
      for (Word value = 1; value <= before; ++value) {
        writer.publish(bytes(filled(value)));
      }
      writer.begin();
      for (std::size_t word = 0; word < steps; ++word) {
        const Word torn = 1000;
        writer.put(word, std::as_bytes(std::span(&torn, 1)));
      }
      RingReader reader = ring.reader();
      EXPECT_EQ(reader.collect(), before > 0);
      EXPECT_EQ(shown(reader), filled(before)) << "died after " << steps << " words";
    }
  }
}

TEST(SharedRing, WhatIsOverwrittenWhileItIsCopiedIsNotShown) {
  Ring ring;
  RingWriter writer = ring.writer();
  writer.publish(bytes(filled(1)));
  // The number says 1, its slot is already being written as number 5.
  ring.words[RingShape::kLine + 1 * kShape.slot_words()] = 2 * 5 - 1;
  RingReader reader = ring.reader();
  EXPECT_FALSE(reader.collect());
  EXPECT_EQ(shown(reader), filled(0));
  EXPECT_GT(reader.torn(), 0U);
}

TEST(SharedRing, EventsComeInOrderAndLostOnesAreCounted) {
  Ring ring;
  RingWriter writer = ring.writer();
  RingReader reader = ring.reader();
  for (Word value = 1; value <= 3; ++value) {
    writer.publish(bytes(filled(value)));
  }
  for (Word value = 1; value <= 3; ++value) {
    ASSERT_TRUE(reader.collect_next());
    EXPECT_EQ(shown(reader), filled(value));
  }
  EXPECT_FALSE(reader.collect_next());
  for (Word value = 4; value <= 13; ++value) {
    writer.publish(bytes(filled(value)));
  }
  for (Word value = 10; value <= 13; ++value) {
    ASSERT_TRUE(reader.collect_next());
    EXPECT_EQ(shown(reader), filled(value));
  }
  EXPECT_EQ(reader.lost(), 6U);
}

// Every value is whole, none comes twice or out of order, and the last one arrives. With a thread sanitizer
// this is also the proof that the slots are handed over properly.
TEST(SharedRing, TwoThreadsSeeWholeValuesInOrder) {
  constexpr Word kLast = 50000;
  Ring ring;
  std::thread producer([&ring] {
    RingWriter writer = ring.writer();
    for (Word value = 1; value <= kLast; ++value) {
      writer.publish(bytes(filled(value)));
    }
  });
  RingReader reader = ring.reader();
  Word previous = 0;
  bool whole = true;
  bool in_order = true;
  while (previous < kLast) {
    if (!reader.collect()) {
      std::this_thread::yield();
      continue;
    }
    const Value value = shown(reader);
    whole = whole && value == filled(value.front());
    in_order = in_order && value.front() > previous && value.front() == reader.number();
    previous = value.front();
  }
  producer.join();
  EXPECT_TRUE(whole);
  EXPECT_TRUE(in_order);
}

// One slot that is always being written, and a value that takes long to copy: many copies are torn, and none
// of those is shown.
TEST(SharedRing, ATornCopyIsNeverShown) {
  constexpr RingShape kLong{1, 8 * 400};
  Ring ring(kLong);
  std::atomic<bool> done{false};
  std::thread producer([&] {
    RingWriter writer = ring.writer();
    std::vector<Word> value(400);
    for (Word k = 1; !done; ++k) {
      std::fill(value.begin(), value.end(), k);
      writer.publish(std::as_bytes(std::span(value)));
      std::this_thread::yield();
    }
  });
  RingReader reader = ring.reader();
  std::vector<Word> value(400);
  bool whole = true;
  for (int collected = 0; collected < 2000 && (collected < 50 || reader.torn() < 50);) {
    if (!reader.collect()) {
      std::this_thread::yield();
      continue;
    }
    ++collected;
    std::memcpy(value.data(), reader.latest().data(), reader.latest().size());
    whole = whole && value == std::vector<Word>(value.size(), reader.number());
  }
  done = true;
  producer.join();
  EXPECT_TRUE(whole);
}

// As above for events: those that arrive are whole and in order, and every one arrives or is counted.
TEST(SharedRing, TwoThreadsLoseNoEventUncounted) {
  constexpr Word kLast = 20000;
  Ring ring({16, sizeof(Value)});
  std::thread producer([&ring] {
    RingWriter writer = ring.writer();
    for (Word value = 1; value <= kLast; ++value) {
      writer.publish(bytes(filled(value)));
    }
  });
  RingReader reader = ring.reader();
  std::uint64_t seen = 0;
  bool whole = true;
  while (reader.number() < kLast) {
    if (reader.collect_next()) {
      ++seen;
      whole = whole && shown(reader) == filled(reader.number());
    } else {
      std::this_thread::yield();
    }
  }
  producer.join();
  EXPECT_TRUE(whole);
  EXPECT_EQ(seen + reader.lost(), kLast);
}

}  // namespace
}  // namespace mayfly::link
