#include "controller/flight/expectations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace mayfly {
namespace {

using Quantity = Expectation::Quantity;
using Comparison = Expectation::Comparison;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Expectation expected(Quantity quantity, Comparison comparison, double wanted) {
  Expectation expectation;
  expectation.quantity = quantity;
  expectation.comparison = comparison;
  expectation.wanted = wanted;
  expectation.text = "as written";
  return expectation;
}

std::optional<double> nobody_counted(const std::string&) {
  return std::nullopt;
}

ExpectationResult held(const Expectation& expectation, const Summary& summary,
                       const ReachedFraction& reached = nobody_counted) {
  return hold_expectations({expectation}, summary, reached).at(0);
}

// The smallest separation stands for every quantity where only the comparison matters.
bool holds(double value, Comparison comparison, double wanted) {
  Summary summary;
  summary.min_separation_m = value;
  return held(expected(Quantity::kMinSeparation, comparison, wanted), summary).pass;
}

TEST(Comparisons, PassAndFailByAHair) {
  const double below = std::nextafter(0.2, 0.0);
  const double above = std::nextafter(0.2, 1.0);
  struct Row {
    Comparison comparison;
    bool below, equal, above;
  };
  for (const Row& row : std::array{
           Row{Comparison::kGreaterEqual, false, true, true}, Row{Comparison::kLessEqual, true, true, false},
           Row{Comparison::kEqual, false, true, false}, Row{Comparison::kGreater, false, false, true},
           Row{Comparison::kLess, true, false, false}}) {
    const int which = static_cast<int>(row.comparison);
    EXPECT_EQ(holds(below, row.comparison, 0.2), row.below) << which;
    EXPECT_EQ(holds(0.2, row.comparison, 0.2), row.equal) << which;
    EXPECT_EQ(holds(above, row.comparison, 0.2), row.above) << which;
    EXPECT_FALSE(holds(kNan, row.comparison, 0.2)) << which;
    EXPECT_FALSE(holds(0.2, row.comparison, kNan)) << which;
  }
}

struct Measurable {
  const char* name;
  Quantity quantity;
  void (*measure)(Summary&, int value);
};

const std::array kMeasurable{
    Measurable{"min_separation", Quantity::kMinSeparation, [](Summary& s, int v) { s.min_separation_m = v; }},
    Measurable{"penetrations", Quantity::kPenetrations,
               [](Summary& s, int v) { s.penetrations = static_cast<std::uint64_t>(v); }},
    Measurable{"collisions", Quantity::kCollisions,
               [](Summary& s, int v) { s.collisions = static_cast<std::uint64_t>(v); }},
    Measurable{"mde_percent", Quantity::kMdePercent, [](Summary& s, int v) { s.mde_percent = v; }},
    Measurable{"max_speed", Quantity::kMaxSpeed, [](Summary& s, int v) { s.max_speed_mps = v; }},
    Measurable{"max_acceleration", Quantity::kMaxAcceleration,
               [](Summary& s, int v) { s.max_acceleration_mps2 = v; }},
    Measurable{"governor_interventions", Quantity::kGovernorInterventions,
               [](Summary& s, int v) { s.governor_interventions = static_cast<std::uint64_t>(v); }},
    Measurable{"missed", Quantity::kMissed,
               [](Summary& s, int v) { s.control.missed = static_cast<std::uint64_t>(v); }},
    Measurable{"faults", Quantity::kFaults,
               [](Summary& s, int v) { s.faults.resize(static_cast<std::size_t>(v)); }}};

TEST(Quantities, AreEachTakenFromTheirOwnPlace) {
  for (const Measurable& measurable : kMeasurable) {
    Summary summary;
    for (const Measurable& other : kMeasurable) {
      other.measure(summary, 8);
    }
    measurable.measure(summary, 3);
    const auto result = held(expected(measurable.quantity, Comparison::kEqual, 3), summary);
    EXPECT_EQ(result.value, 3.0) << measurable.name;
    EXPECT_TRUE(result.pass) << measurable.name;
    EXPECT_FALSE(held(expected(measurable.quantity, Comparison::kLess, 3), summary).pass) << measurable.name;
    EXPECT_TRUE(held(expected(measurable.quantity, Comparison::kLess, 4), summary).pass) << measurable.name;
  }
}

TEST(Quantities, ThatWereNotMeasuredAreEmptyAndPassNothing) {
  for (const Quantity quantity :
       {Quantity::kReached, Quantity::kMinSeparation, Quantity::kPenetrations, Quantity::kCollisions,
        Quantity::kMdePercent, Quantity::kMaxSpeed, Quantity::kMaxAcceleration}) {
    for (const Comparison comparison : {Comparison::kGreaterEqual, Comparison::kLessEqual, Comparison::kEqual,
                                        Comparison::kGreater, Comparison::kLess}) {
      const auto result = held(expected(quantity, comparison, 0), Summary{});
      EXPECT_EQ(result.value, std::nullopt);
      EXPECT_FALSE(result.pass);
    }
  }
}

TEST(Reached, IsAskedForTheSwarmThatIsNamed) {
  const auto reached = [](const std::string& swarm) -> std::optional<double> {
    return swarm == "bees" ? 0.75 : 0.25;
  };
  Expectation bees = expected(Quantity::kReached, Comparison::kGreaterEqual, 0.75);
  bees.swarm = "bees";
  EXPECT_EQ(held(bees, {}, reached).value, 0.75);
  EXPECT_TRUE(held(bees, {}, reached).pass);
  bees.swarm = "";
  EXPECT_EQ(held(bees, {}, reached).value, 0.25);
  EXPECT_FALSE(held(bees, {}, reached).pass);
}

TEST(Quantities, ThatAreMeasuredOnlyWhereTheyAreAskedForGoByTheirPlace) {
  const std::vector<std::optional<double>> asked = {1.0, std::nullopt, 3.0};
  const auto results = hold_expectations({expected(Quantity::kCentreDrift, Comparison::kEqual, 1.0),
                                          expected(Quantity::kTurns, Comparison::kGreaterEqual, 0.0),
                                          expected(Quantity::kWallClearance, Comparison::kGreaterEqual, 3.5)},
                                         {}, nobody_counted, asked);
  EXPECT_TRUE(results.at(0).pass);
  EXPECT_FALSE(results.at(1).value || results.at(1).pass);  // not measured
  EXPECT_EQ(results.at(2).value, 3.0);
  EXPECT_FALSE(results.at(2).pass);
  EXPECT_FALSE(held(expected(Quantity::kSpread, Comparison::kGreaterEqual, 0.0), {}).pass);
}

TEST(Quantities, AgeOfFieldsIsTheOldest) {
  const auto age = expected(Quantity::kFieldAge, Comparison::kLessEqual, 0.5);
  Summary summary;
  EXPECT_FALSE(held(age, summary).value);
  summary.fields = FieldsSummary{};
  EXPECT_FALSE(held(age, summary).value);
  summary.fields->age_s = Spread{0.1, 0.2, 0.4};
  EXPECT_EQ(held(age, summary).value, 0.4);
  EXPECT_TRUE(held(age, summary).pass);
}

TEST(Results, RepeatWhatWasWantedInTheOrderOfTheScenario) {
  auto first = expected(Quantity::kFaults, Comparison::kEqual, 0);
  auto second = expected(Quantity::kMdePercent, Comparison::kLessEqual, 0.36);
  second.text = "mde_percent";
  const auto results = hold_expectations({first, second}, {}, nobody_counted);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].name, "as written");
  EXPECT_EQ(results[0].wanted, "== 0");
  EXPECT_EQ(results[1].name, "mde_percent");
  EXPECT_EQ(results[1].wanted, "<= 0.36");
  EXPECT_TRUE(hold_expectations({}, {}, nobody_counted).empty());
}

}  // namespace
}  // namespace mayfly
