// Every agent's state and command over time, as CSV.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "controller/flight/observer.hpp"
#include "core/result.hpp"
#include "record/csv_text.hpp"
#include "record/frame_ring.hpp"
#include "record/output_file.hpp"
#include "record/sampling.hpp"

namespace mayfly::record {

struct CsvOptions {
  std::size_t agents = 0;
  double rate_hz = 20.0;  // of the recording; every tick, where it is above the control rate
  double control_hz = 100.0;
  // A flight on the real clock hands its frames to a thread, so that no disk can delay a tick; frames that
  // the disk can't keep up with are dropped. On the virtual clock nothing is dropped: the flight waits for
  // the disk.
  bool realtime = false;
};

struct RecordingReport {
  std::uint64_t frames = 0;  // in the file
  std::uint64_t lost = 0;    // where frames are missing, the file has a line "# gap: …"
  int error_number = 0;      // errno of the last write that failed
};

// Columns tick, t (s), id (index of the agent), position (m), velocity (m/s), command (m/s), the command's
// kind, and 0 where the state is an old sample. The file appears under its name at close().
class CsvRecorder final : public Observer {
 public:
  static Result<std::unique_ptr<CsvRecorder>> open(const std::filesystem::path& path,
                                                   const CsvOptions& options);
  CsvRecorder(const CsvRecorder&) = delete;
  CsvRecorder& operator=(const CsvRecorder&) = delete;
  ~CsvRecorder() override;

  void on_tick(const TickView& view) noexcept override;

  // Writes what is left. A recording with marked gaps is a success, which the report tells; it is an error if
  // nothing at all could be written, or the end is missing: then what there is keeps its temporary name.
  Result<RecordingReport> close();

 private:
  CsvRecorder(OutputFile file, const CsvOptions& options);
  void write_frame(const TickView& view, std::uint64_t lost_before) noexcept;
  void flush() noexcept;
  void write_from_ring() noexcept;
  void stop_writer() noexcept;
  std::string give_up();

  Sampling sampling_;
  std::size_t frame_bytes_;
  OutputFile file_;
  CsvText text_;
  std::uint64_t frames_in_text_ = 0;
  std::uint64_t gaps_in_text_ = 0;   // frames that its gap lines tell of
  std::uint64_t unmarked_lost_ = 0;  // lost, and no gap line tells of them yet
  bool has_header_ = false;
  RecordingReport report_;

  std::unique_ptr<FrameRing> ring_;  // none: frames are written by the tick itself
  std::atomic<bool> stop_{false};
  std::thread writer_;
};

}  // namespace mayfly::record
