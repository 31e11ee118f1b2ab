#include "record/csv_recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <charconv>
#include <cmath>
#include <csignal>
#include <limits>
#include <sstream>

#include "tests/unit/record/frames.hpp"

namespace mayfly::record {
namespace {

using ::testing::HasSubstr;

std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

float number(const std::string& text) {
  float value = 0.0F;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::unique_ptr<CsvRecorder> open(const std::filesystem::path& path, std::size_t agents,
                                  bool realtime = false) {
  return std::move(CsvRecorder::open(path, {agents, 100.0, 100.0, realtime}).value());
}

TEST(CsvRecorder, GivesEveryFloatBack) {
  const test::Folder folder;
  test::Frames frames(3);
  const std::vector<float> hard{0.1F,        -1.17549435e-38F, std::nextafter(1.0F, 2.0F),
                                16777217.0F, 3.4028235e38F,    -0.0F,
                                1e-45F,      1.0F / 3.0F,      std::numeric_limits<float>::infinity()};
  for (std::size_t c = 0; c < 9; ++c) {
    frames.numbers[c][1] = hard[c];
  }
  frames.kinds[1] = CommandKind::kHold;
  frames.valid[1] = 0;
  auto recorder = open(folder.path / "r.csv", 3);
  recorder->on_tick(frames.at(7));
  ASSERT_TRUE(recorder->close());

  const auto rows = rows_of(test::text_of(folder.path / "r.csv"));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[0], ::testing::ElementsAre("tick", "t", "id", "x", "y", "z", "vx", "vy", "vz", "cx", "cy",
                                              "cz", "kind", "valid"));
  ASSERT_EQ(rows[2].size(), 14U);
  EXPECT_EQ(rows[2][0], "7");
  EXPECT_EQ(rows[2][1], "0.07");
  EXPECT_EQ(rows[2][2], "1");
  EXPECT_EQ(rows[2][3], "0.1");
  for (std::size_t c = 0; c < 9; ++c) {
    EXPECT_EQ(number(rows[2][3 + c]), hard[c]);
  }
  EXPECT_EQ(rows[2][12], "hold");
  EXPECT_EQ(rows[2][13], "0");
  EXPECT_EQ(rows[1][12], "velocity");
}

TEST(CsvRecorder, NoAgentsAndNoTicksIsAHeader) {
  const test::Folder folder;
  auto recorder = open(folder.path / "r.csv", 0);
  recorder->on_tick(test::Frames(0).at(0));
  ASSERT_TRUE(recorder->close());
  EXPECT_EQ(test::text_of(folder.path / "r.csv"), kCsvHeader);
}

TEST(CsvRecorder, BothWaysOfWritingGiveTheSameBytes) {
  const test::Folder folder;
  test::Frames frames(5);
  auto tick = open(folder.path / "tick.csv", 5, false);
  auto thread = open(folder.path / "thread.csv", 5, true);
  for (std::uint64_t t = 0; t < 60; ++t) {  // fewer than the ring holds: nothing may be lost
    frames.numbers[t % 9][t % 5] += 0.1F;
    tick->on_tick(frames.at(t));
    thread->on_tick(frames.at(t));
  }
  ASSERT_TRUE(tick->close());
  const auto report = thread->close();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->frames, 60U);
  EXPECT_EQ(report->lost, 0U);
  EXPECT_EQ(test::text_of(folder.path / "tick.csv"), test::text_of(folder.path / "thread.csv"));
}

TEST(CsvRecorder, UnclosedLeavesNothing) {
  const test::Folder folder;
  for (const bool realtime : {false, true}) {
    open(folder.path / "r.csv", 2, realtime)->on_tick(test::Frames(2).at(0));
    EXPECT_TRUE(folder.empty());
  }
}

TEST(CsvRecorder, AFullDiskIsAnErrorAtTheEnd) {
  auto recorder = open("/dev/full", 2);
  for (std::uint64_t tick = 0; tick < 10; ++tick) {
    recorder->on_tick(test::Frames(2).at(tick));
  }
  const auto report = recorder->close();
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().cause, Cause::kEnvironment);
  EXPECT_THAT(report.error().message, HasSubstr("10 of 10 frames lost (No space left on device)"));
}

// A file may not grow beyond a limit: what a full disk looks like, and then room again.
class FileSizeLimit {
 public:
  FileSizeLimit() {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
  }
  ~FileSizeLimit() { lift(); }
  void set(rlim_t bytes) const {
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  void lift() const { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

constexpr std::size_t kLarge =
    8000;  // agents, whose one frame is more than the buffer's megabyte: each is written at once

TEST(CsvRecorder, MarksTheGapOnceThereIsRoomAgain) {
  const test::Folder folder;
  const test::Frames frames(kLarge);
  auto recorder = open(folder.path / "r.csv", kLarge);
  const FileSizeLimit limit;
  limit.set(1000);
  for (std::uint64_t tick = 0; tick < 4; ++tick) {
    recorder->on_tick(frames.at(tick));
  }
  limit.lift();
  recorder->on_tick(frames.at(4));
  recorder->on_tick(frames.at(5));
  const auto report = recorder->close();
  ASSERT_TRUE(report) << to_string(report.error());
  EXPECT_EQ(report->frames + report->lost, 6U);
  EXPECT_EQ(report->lost, 3U);
  const std::string text = test::text_of(folder.path / "r.csv");
  EXPECT_EQ(rows_of(text).size(), 1 + 3 * kLarge + 1);
  // The frame of tick 3 was still in memory when there was room again. The text is too long to be printed
  // whole.
  const std::string start = std::string(kCsvHeader) + "# gap: 3 frames lost before tick 3\n3,0.03,0,";
  EXPECT_EQ(text.substr(0, start.size()), start);
}

TEST(CsvRecorder, AMissingEndKeepsTheTemporaryName) {
  const test::Folder folder;
  const test::Frames frames(kLarge);
  auto recorder = open(folder.path / "r.csv", kLarge);
  recorder->on_tick(frames.at(0));
  recorder->on_tick(frames.at(1));  // tick 0 is on the disk now
  const FileSizeLimit limit;
  limit.set(1000);
  const auto report = recorder->close();
  limit.lift();
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, AllOf(HasSubstr("1 of 2 frames lost"), HasSubstr("r.csv.partial")));
  EXPECT_FALSE(std::filesystem::exists(folder.path / "r.csv"));
  EXPECT_EQ(rows_of(test::text_of(folder.path / "r.csv.partial")).size(), 1 + kLarge);
}

}  // namespace
}  // namespace mayfly::record
