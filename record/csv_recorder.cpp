#include "record/csv_recorder.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace mayfly::record {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;
constexpr std::size_t kRingBytes = std::size_t{64} << 20;
constexpr std::size_t kBytesAnAgent = 9 * sizeof(float) + 2;
// The producer must not make a system call, so nobody wakes the writer: it looks, a few times a frame.
constexpr auto kWriterNap = std::chrono::milliseconds(5);

std::size_t ring_frames(std::size_t agents) {
  return std::clamp<std::size_t>(kRingBytes / (kBytesAnAgent * std::max<std::size_t>(agents, 1)), 4, 64);
}

}  // namespace

Result<std::unique_ptr<CsvRecorder>> CsvRecorder::open(const std::filesystem::path& path,
                                                       const CsvOptions& options) {
  auto file = OutputFile::create(path);
  if (!file) {
    return fail(std::move(file.error()));
  }
  return std::unique_ptr<CsvRecorder>(new CsvRecorder(std::move(*file), options));
}

CsvRecorder::CsvRecorder(OutputFile file, const CsvOptions& options)
    : sampling_(options.rate_hz, options.control_hz),
      frame_bytes_(CsvText::frame_bytes(options.agents)),
      file_(std::move(file)),
      text_(std::max(kBufferBytes, frame_bytes_ + kCsvHeader.size())) {
  text_.append(kCsvHeader);
  if (options.realtime) {
    ring_ = std::make_unique<FrameRing>(ring_frames(options.agents), options.agents);
    writer_ = std::thread([this] { write_from_ring(); });
  }
}

CsvRecorder::~CsvRecorder() {
  stop_writer();
}

void CsvRecorder::on_tick(const TickView& view) noexcept {
  if (!sampling_.takes(view.tick)) {
    return;
  }
  if (ring_) {
    ring_->push(view);
  } else {
    write_frame(view, 0);
  }
}

void CsvRecorder::write_frame(const TickView& view, std::uint64_t lost_before) noexcept {
  if (!text_.has_room(frame_bytes_)) {
    flush();
  }
  report_.lost += lost_before;
  if (const std::uint64_t gap = lost_before + std::exchange(unmarked_lost_, 0); gap > 0) {
    text_.append_gap(gap, view.tick);
    gaps_in_text_ += gap;
  }
  text_.append_frame(view);
  ++frames_in_text_;
}

void CsvRecorder::flush() noexcept {
  if (file_.write(text_.text())) {
    report_.frames += frames_in_text_;
    has_header_ = true;
  } else {
    report_.lost += frames_in_text_;
    unmarked_lost_ += frames_in_text_ + gaps_in_text_;
  }
  frames_in_text_ = 0;
  gaps_in_text_ = 0;
  text_.clear();
  if (!has_header_) {
    text_.append(kCsvHeader);
  }
}

void CsvRecorder::write_from_ring() noexcept {
  while (true) {
    const bool last_look = stop_.load(std::memory_order_acquire);
    while (const FrameRing::Frame* frame = ring_->front()) {
      write_frame(frame->view, frame->lost_before);
      ring_->pop();
    }
    if (last_look) {
      return;
    }
    std::this_thread::sleep_for(kWriterNap);
  }
}

void CsvRecorder::stop_writer() noexcept {
  if (writer_.joinable()) {
    stop_.store(true, std::memory_order_release);
    writer_.join();
  }
}

Result<RecordingReport> CsvRecorder::close() {
  stop_writer();
  if (const std::uint64_t lost = ring_ ? ring_->lost_at_end() : 0; lost > 0) {
    if (!text_.has_room(frame_bytes_)) {
      flush();
    }
    report_.lost += lost;
    gaps_in_text_ += lost;
    text_.append_gap_at_end(lost);
  }
  flush();
  report_.error_number = file_.error_number();
  if (unmarked_lost_ > 0) {
    return fail(Cause::kEnvironment, give_up());
  }
  if (auto committed = file_.commit(); !committed) {
    return fail(std::move(committed.error()));
  }
  return report_;
}

std::string CsvRecorder::give_up() {
  auto text = "recording '" + file_.path().string() + "' is incomplete: " + std::to_string(report_.lost) +
              " of " + std::to_string(report_.lost + report_.frames) + " frames lost (" +
              std::generic_category().message(report_.error_number) + ")";
  if (report_.frames > 0) {
    const auto kept = file_.leave_partial();
    text += kept.empty() ? "" : "; what there is stands in '" + kept.string() + "'";
  }
  return text;
}

}  // namespace mayfly::record
