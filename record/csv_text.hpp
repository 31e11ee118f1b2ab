// The text of a CSV recording, appended to memory that is already there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "controller/flight/observer.hpp"

namespace mayfly::record {

inline constexpr std::string_view kCsvHeader = "tick,t,id,x,y,z,vx,vy,vz,cx,cy,cz,kind,valid\n";

// "none", "velocity", "hold", "take_off", "land", "stop".
std::string_view name_of(CommandKind kind) noexcept;

// A buffer that never grows. Numbers are written in the fewest digits that give the same float back.
class CsvText {
 public:
  explicit CsvText(std::size_t capacity) : buffer_(capacity) {}

  // The most that one frame of `agents` can take, a gap marker before it included.
  static std::size_t frame_bytes(std::size_t agents) noexcept;
  bool has_room(std::size_t bytes) const noexcept { return buffer_.size() - size_ >= bytes; }

  // Callers see to it that there is room.
  void append(std::string_view text) noexcept;
  // One line an agent.
  void append_frame(const TickView& view) noexcept;
  // "# gap: 12 frames lost before tick 480"
  void append_gap(std::uint64_t frames, std::uint64_t tick) noexcept;
  // "# gap: 12 frames lost at the end"
  void append_gap_at_end(std::uint64_t frames) noexcept;

  std::string_view text() const noexcept { return {buffer_.data(), size_}; }
  void clear() noexcept { size_ = 0; }

 private:
  template <class Number>
  void append_number(Number number) noexcept;
  void append_row(const TickView& view, std::string_view prefix, std::size_t agent) noexcept;

  std::vector<char> buffer_;
  std::size_t size_ = 0;
};

}  // namespace mayfly::record
