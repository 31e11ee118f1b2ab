// What a black box has kept can be read back.
#include "record/black_box_csv.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

namespace mayfly::record {
namespace {

std::vector<std::vector<std::string>> cells_of(const std::string& text) {
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

TEST(BlackBoxCsv, HasALineARobotAndTickThatReadsBack) {
  BlackBox box({.seconds = 1.0}, std::chrono::milliseconds(10), 2);
  const std::vector<float> place{1.0F / 3.0F, -2.5F}, zero(2);
  const std::vector<CommandKind> kind{CommandKind::kVelocity, CommandKind::kHold};
  const std::vector<Time> stamp(2);
  const std::vector<std::uint8_t> one(2, 1);
  std::vector<Symptoms> symptoms(2);
  symptoms[1].add(Symptom::kStalePose);
  symptoms[1].add(Symptom::kBatteryLow);
  const std::vector<RobotState> states{RobotState::kFlying, RobotState::kTakingOff};
  const std::vector<Severity> severities{Severity::kNone, Severity::kHold};
  const WishDesk desk(2, Time(1));
  for (int tick = 1; tick <= 3; ++tick) {
    const TickOutcome outcome{tick * std::chrono::milliseconds(10),
                              {kind, place, zero, zero, Time{0}, static_cast<std::uint64_t>(tick)},
                              {place, zero, zero, zero, zero, zero, stamp, one, symptoms, {}, {}},
                              states,
                              severities,
                              one,
                              symptoms,
                              false};
    Symptoms everybody;
    everybody.add(Symptom::kTickLate);
    box.keep({outcome, desk, symptoms, everybody, tick < 3});
  }
  box.seal();
  const std::vector<std::string> names{"first", "second"};
  const auto rows = cells_of(black_box_csv(*box.sealed(), names));
  ASSERT_EQ(rows.size(), 7U);
  for (const auto& row : rows) {
    EXPECT_EQ(row.size(), rows[0].size());
  }
  const auto cell = [&](std::size_t row, const std::string& column) {
    for (std::size_t c = 0; c < rows[0].size(); ++c) {
      if (rows[0][c] == column) {
        return rows[row][c];
      }
    }
    return std::string("no column " + column);
  };
  EXPECT_EQ(cell(1, "t"), "0.01");
  EXPECT_EQ(cell(6, "sequence"), "3");
  EXPECT_EQ(cell(4, "held") + cell(6, "held"), "10");
  EXPECT_EQ(cell(1, "everybody"), "tick_late");
  EXPECT_EQ(cell(1, "robot") + ' ' + cell(2, "robot"), "first second");
  EXPECT_EQ(std::stof(cell(1, "x")), place[0]);
  EXPECT_EQ(std::stof(cell(2, "sent_x")), place[1]);
  EXPECT_EQ(cell(2, "symptoms"), "stale_pose+battery_low");
  EXPECT_EQ(cell(2, "severity"), "hold");
  EXPECT_EQ(cell(2, "state"), "taking off");
  EXPECT_EQ(cell(1, "sent") + ' ' + cell(2, "sent"), "velocity hold");
}

}  // namespace
}  // namespace mayfly::record
