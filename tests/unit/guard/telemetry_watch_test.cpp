// Who is silent, whose link is bad, whose battery is low: each at its limit and a step before it.
#include "controller/guard/telemetry_watch.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace mayfly::test {
namespace {

using std::chrono::milliseconds;

struct Told {
  Symptoms update(Time now) {
    watch.update(now, {&telemetry, 1}, {&stamp, 1}, {&known, 1});
    return watch.symptoms()[0];
  }
  TelemetryWatch watch{1, TelemetryLimits{}};
  Telemetry telemetry;
  Time stamp{0};
  std::uint8_t known = 1;
};

TEST(TelemetryWatch, AHalThatTellsNothingIsNotSuspected) {
  Told told;
  for (Time now{0}; now < std::chrono::seconds(2); now += milliseconds(10)) {
    told.stamp = now;
    ASSERT_TRUE(told.update(now).empty());
  }
}

TEST(TelemetryWatch, SilentIsWhoWasNotHeardForLongerThanTheLimit) {
  Told told;
  told.telemetry.heard = milliseconds(1000);
  EXPECT_TRUE(told.update(milliseconds(1200)).empty());
  EXPECT_TRUE(told.update(milliseconds(1200) + Time(1)).has(Symptom::kSilent));
  told.telemetry.heard = milliseconds(1201);
  EXPECT_TRUE(told.update(milliseconds(1202)).empty()) << "it clears with the first answer";
}

TEST(TelemetryWatch, APoseIsAnAnswerWhereTheLinkTellsOfNone) {
  Told told;
  told.stamp = milliseconds(1000);
  EXPECT_TRUE(told.update(milliseconds(1200)).empty());
  EXPECT_TRUE(told.update(milliseconds(1201)).has(Symptom::kSilent));
  told.telemetry.heard = milliseconds(1000);
  told.stamp = milliseconds(1201);
  EXPECT_TRUE(told.update(milliseconds(1201)).has(Symptom::kSilent)) << "it is seen from outside";
}

TEST(TelemetryWatch, WhoWasNeverHeardCannotFallSilent) {
  Told told;
  told.known = 0;
  EXPECT_TRUE(told.update(std::chrono::hours(1)).empty());
}

TEST(TelemetryWatch, ALinkIsBadBelowItsLeastQuality) {
  Told told;
  told.telemetry.link_quality = 0.85F;
  EXPECT_TRUE(told.update(Time{0}).empty());
  told.telemetry.link_quality = 0.84F;
  EXPECT_TRUE(told.update(Time{0}).has(Symptom::kLinkDegraded));
}

TEST(TelemetryWatch, ABatteryIsLowThenCritical) {
  Told told;
  for (const auto& [charge, low, critical] :
       {std::tuple{0.3F, false, false}, std::tuple{0.29F, true, false}, std::tuple{0.15F, true, false},
        std::tuple{0.14F, false, true}}) {
    told.telemetry.battery = charge;
    const Symptoms symptoms = told.update(Time{0});
    EXPECT_EQ(symptoms.has(Symptom::kBatteryLow), low) << charge;
    EXPECT_EQ(symptoms.has(Symptom::kBatteryCritical), critical) << charge;
    EXPECT_FALSE(symptoms.has(Symptom::kBatteryUnknown)) << charge;
  }
}

TEST(TelemetryWatch, AChargeThatJumpsOrIsNoNumberIsUnknown) {
  Told told;
  told.telemetry.battery = 0.9F;
  EXPECT_TRUE(told.update(Time{0}).empty());
  told.telemetry.battery = 0.71F;
  EXPECT_TRUE(told.update(Time{0}).empty()) << "as fast as allowed";
  told.telemetry.battery = 0.5F;
  EXPECT_TRUE(told.update(Time{0}).has(Symptom::kBatteryUnknown));
  EXPECT_TRUE(told.update(Time{0}).empty()) << "where it stays it is believed";
  told.telemetry.battery = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(told.update(Time{0}).has(Symptom::kBatteryUnknown)) << "it was told before";
}

}  // namespace
}  // namespace mayfly::test
