#include "record/csv_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace mayfly::record {
namespace {

// Shortest round trip: a float takes 16 characters at most (-1.17549435e-38), a double 24, an integer 20.
constexpr std::size_t kRowBytes = 20 + 24 + 20 + 9 * 16 + 8 + 1 + 14;
constexpr std::size_t kGapBytes = 96;

}  // namespace

std::string_view name_of(CommandKind kind) noexcept {
  constexpr std::array<std::string_view, 6> kNames{"none", "velocity", "hold", "take_off", "land", "stop"};
  const auto index = static_cast<std::size_t>(kind);
  return index < kNames.size() ? kNames[index] : "unknown";
}

std::size_t CsvText::frame_bytes(std::size_t agents) noexcept {
  return kGapBytes + agents * kRowBytes;
}

void CsvText::append(std::string_view text) noexcept {
  std::copy(text.begin(), text.end(), buffer_.data() + size_);
  size_ += text.size();
}

template <class Number>
void CsvText::append_number(Number number) noexcept {
  char* const end = buffer_.data() + buffer_.size();
  size_ = static_cast<std::size_t>(std::to_chars(buffer_.data() + size_, end, number).ptr - buffer_.data());
}

void CsvText::append_frame(const TickView& view) noexcept {
  if (view.x.empty()) {
    return;
  }
  // "tick,t," is the same in every row of the frame: formatted once.
  const std::size_t start = size_;
  append_number(view.tick);
  append(",");
  append_number(to_seconds(view.time));
  append(",");
  std::array<char, 48> prefix{};
  const std::size_t length = size_ - start;
  std::copy_n(buffer_.data() + start, length, prefix.data());
  size_ = start;
  for (std::size_t agent = 0; agent < view.x.size(); ++agent) {
    append_row(view, {prefix.data(), length}, agent);
  }
}

void CsvText::append_row(const TickView& view, std::string_view prefix, std::size_t agent) noexcept {
  append(prefix);
  append_number(agent);
  for (const auto& column :
       {view.x, view.y, view.z, view.vx, view.vy, view.vz, view.command_x, view.command_y, view.command_z}) {
    append(",");
    append_number(column[agent]);
  }
  append(",");
  append(view.is_there(agent) ? name_of(view.kind[agent]) : "absent");
  append(view.valid[agent] != 0 ? ",1\n" : ",0\n");
}

void CsvText::append_gap(std::uint64_t frames, std::uint64_t tick) noexcept {
  append("# gap: ");
  append_number(frames);
  append(" frames lost before tick ");
  append_number(tick);
  append("\n");
}

void CsvText::append_gap_at_end(std::uint64_t frames) noexcept {
  append("# gap: ");
  append_number(frames);
  append(" frames lost at the end\n");
}

}  // namespace mayfly::record
