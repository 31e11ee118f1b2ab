// The last seconds before something went wrong: what was known, wished, sent, and why.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/guard/invariants.hpp"
#include "controller/guard/monitor.hpp"
#include "controller/guard/wish_desk.hpp"

namespace mayfly {

struct BlackBoxConfig {
  double seconds = 5.0;
  std::size_t most_bytes = std::size_t{64} << 20U;  // less than `seconds` are kept where this is not enough
};

// Of one robot at one tick; m, m/s, world frame.
struct BlackBoxRow {
  float x = 0, y = 0, z = 0, vx = 0, vy = 0, vz = 0;  // estimated
  float wish_x = 0, wish_y = 0, wish_z = 0;
  float sent_x = 0, sent_y = 0, sent_z = 0;
  Symptoms symptoms;
  CommandKind wish = CommandKind::kNone;
  CommandKind sent = CommandKind::kNone;
  Severity severity = Severity::kNone;
  RobotState state = RobotState::kUnknown;
  std::uint8_t known = 0;
};

struct BlackBoxFrame {
  Time time{0};
  std::uint64_t sequence = 0;  // of what was sent
  Symptoms everybody;
  bool held = true;  // all invariants did
};

// What one incident left, oldest tick first.
class BlackBoxTape {
 public:
  BlackBoxTape(std::size_t frames, std::size_t robots)
      : robots_(robots), frames_(frames), rows_(frames * robots) {}

  std::size_t size() const noexcept { return size_; }
  std::size_t robots() const noexcept { return robots_; }
  const BlackBoxFrame& frame(std::size_t i) const noexcept { return frames_[at(i)]; }
  std::span<const BlackBoxRow> rows(std::size_t i) const noexcept {
    return {rows_.data() + at(i) * robots_, robots_};
  }

 private:
  friend class BlackBox;
  std::size_t at(std::size_t i) const noexcept { return (first_ + i) % frames_.size(); }
  // The next frame, in place of the oldest where all are taken.
  std::size_t next() noexcept;

  std::size_t robots_, first_ = 0, size_ = 0;
  std::vector<BlackBoxFrame> frames_;
  std::vector<BlackBoxRow> rows_;
};

// Two tapes: one is written by the tick; the other, once something has happened, belongs to whoever stores
// it, for as long as that takes. The tick waits for nobody: what happens meanwhile is counted, not kept.
class BlackBox {
 public:
  BlackBox(const BlackBoxConfig& config, Time period, std::size_t robots);

  struct Tick {
    const TickOutcome& outcome;
    const WishDesk& wish;
    std::span<const Symptoms> symptoms;
    Symptoms everybody;
    bool held;
  };
  // The tick's thread only.
  void keep(const Tick& tick) noexcept;
  // Something went wrong at the tick that was kept last. False where the tape before was not stored yet.
  bool seal() noexcept;

  // Any one other thread: the sealed tape, or null. It stays until release().
  const BlackBoxTape* sealed() const noexcept;
  void release() noexcept;

  std::uint64_t incidents() const noexcept { return incidents_; }  // the tick's thread, or when it has ended

 private:
  std::vector<BlackBoxTape> tapes_;
  std::size_t running_ = 0;
  std::uint64_t incidents_ = 0;
  std::atomic<bool> is_sealed_{false};
};

}  // namespace mayfly
