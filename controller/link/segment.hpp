// The memory that planner and guard share: one sealed segment with a header that both check.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "controller/link/messages.hpp"
#include "controller/link/shared_ring.hpp"
#include "core/clock.hpp"
#include "core/hal.hpp"
#include "core/result.hpp"

namespace mayfly::link {

inline constexpr Word kMagic = 0x676e696c79616d00U;  // "\0mayling"
inline constexpr Word kVersion = 2;                  // of everything in this folder that crosses

// What the planner wants of the guard, and how far the guard is: levels again.
enum class Want : Word { kWait, kFly, kEnd };
enum class Phase : Word { kStarting, kReady, kActive, kEnding, kEnded };

// Words at the start of the segment. What one side writes has cache lines of its own.
struct Header {
  SharedWord magic, version, robots, layout, bytes, epoch_ns;
  alignas(64) SharedWord planner;  // lease; 0: nobody's
  SharedWord want, planner_beat;
  alignas(64) SharedWord guard;  // lease
  SharedWord phase, guard_beat;
  alignas(64) SharedWord leases_refused;  // to those who came second, on either side
};

// The robots that both sides mean, in their order.
struct Roster {
  std::uint32_t count = 0;
  Word names = 0;  // a hash
};
Roster roster_of(std::span<const RobotInfo> robots);

// Where each ring lies.
struct Layout {
  RingShape wish, operators, view, events;
  std::size_t wish_at = 0, operators_at = 0, view_at = 0, events_at = 0;  // words from the start
  std::size_t words = 0;
  Word hash = 0;  // of all that both sides must agree on: version, robots, shapes, places
};
Layout layout_of(const Roster& roster);

class Segment {
 public:
  // Makes one, sealed so that nobody can shrink it under the other's feet. `epoch` is the run's time 0 on
  // CLOCK_MONOTONIC. Fails where the system has no memory or no descriptor left.
  static Result<Segment> create(const Roster& roster, Time epoch);
  // Maps one that another process made; `descriptor` is its from now on. Refuses what is not a segment, can
  // be shrunk, is of another version or size, or is for other robots.
  static Result<Segment> attach(int descriptor, const Roster& roster);

  Segment(Segment&&) noexcept = default;
  Segment& operator=(Segment&&) noexcept = default;
  Segment(const Segment&) = delete;
  Segment& operator=(const Segment&) = delete;
  ~Segment() = default;

  int descriptor() const noexcept { return handle_->descriptor; }
  Header& header() const noexcept { return *reinterpret_cast<Header*>(handle_->memory); }
  const Layout& layout() const noexcept { return layout_; }
  std::size_t robots() const noexcept { return robots_; }
  Time epoch() const noexcept { return Time(static_cast<Time::rep>(header().epoch_ns.load())); }

  std::span<SharedWord> wish() const noexcept { return ring(layout_.wish_at, layout_.wish); }
  std::span<SharedWord> operators() const noexcept { return ring(layout_.operators_at, layout_.operators); }
  std::span<SharedWord> view() const noexcept { return ring(layout_.view_at, layout_.view); }
  std::span<SharedWord> events() const noexcept { return ring(layout_.events_at, layout_.events); }

 private:
  struct Handle {
    explicit Handle(int file) : descriptor(file) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle();
    Result<void> map(std::size_t size);

    int descriptor;
    std::byte* memory = nullptr;
    std::size_t bytes = 0;
  };

  Segment(std::unique_ptr<Handle> handle, const Roster& roster, Layout layout)
      : handle_(std::move(handle)), layout_(layout), robots_(roster.count) {}

  std::span<SharedWord> ring(std::size_t at, RingShape shape) const noexcept {
    return {reinterpret_cast<SharedWord*>(handle_->memory) + at, shape.words()};
  }
  std::unique_ptr<Handle> handle_;
  Layout layout_;
  std::size_t robots_;
};

// Takes a lease that nobody has: `lease` (of `header`) is 0 till then. The holder's process is told by its
// upper half. Fails, naming the holder, where it is taken, and counts that: there is one owner of commands.
Result<Word> take_lease(Header& header, SharedWord& lease, const std::string& what);

}  // namespace mayfly::link
