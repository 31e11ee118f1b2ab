// A small comparison: the verdicts that hold however small it is, and what programs read.
#include "bench/noise/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "bench/noise/report.hpp"

namespace mayfly::bench {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

const NoiseComparison& small() {
  static const auto kMade = compare_noises({.agents = 120, .duration_s = 30.0, .seeds = 2, .threads = 2});
  if (!kMade) {
    ADD_FAILURE() << to_string(kMade.error().front());
    std::abort();
  }
  return *kMade;
}

const VariantResult& variant(SteeredBy model, NoiseKind noise) {
  for (const VariantResult& v : small().variants) {
    if (v.model == model && v.noise == noise) {
      return v;
    }
  }
  std::abort();
}

// The noise alone decides these: they are derived, not fitted.
TEST(Comparison, RandomNoiseVibratesInEveryModel) {
  for (const SteeredBy model : {SteeredBy::kPath, SteeredBy::kBoids, SteeredBy::kCrowd}) {
    const VariantResult& random = variant(model, NoiseKind::kWhite);
    // A white heading's differences: ½ + 1/π of the power, less for headings that are not white at all.
    EXPECT_NEAR(random.mean(&Measures::turning_high), 0.818, 0.03);
    // n independent steps carry √n of what n equal ones would: √(1/100).
    EXPECT_NEAR(random.mean(&Measures::noise_reach), 0.1, 0.01);
  }
}

// Stagnant places: in noise with sinks agents get stuck, in noise without divergence they cannot, for nothing
// that moves without divergence comes to rest in a place of its own.
TEST(Comparison, OnlyPerlinNoiseHoldsAgents) {
  EXPECT_GT(variant(SteeredBy::kPath, NoiseKind::kPerlin).least(&Measures::stuck_share), 0.1);
  EXPECT_EQ(variant(SteeredBy::kPath, NoiseKind::kCurl).most(&Measures::stuck_share), 0);
  EXPECT_EQ(variant(SteeredBy::kPath, NoiseKind::kWhite).most(&Measures::stuck_share), 0);
  EXPECT_GT(variant(SteeredBy::kPath, NoiseKind::kCurl).mean(&Measures::progress), 0.95);
}

TEST(Comparison, PerlinNoiseGathersAgentsAndCurlNoiseDoesNot) {
  const double perlin = variant(SteeredBy::kPath, NoiseKind::kPerlin).mean(&Measures::clumping);
  const double curl = variant(SteeredBy::kPath, NoiseKind::kCurl).mean(&Measures::clumping);
  const double none = variant(SteeredBy::kPath, NoiseKind::kNone).mean(&Measures::clumping);
  EXPECT_GT(perlin, 1.3 * curl);
  EXPECT_LT(curl, 1.1 * none);
}

TEST(Comparison, CurlNoiseTurnsSmoothly) {
  const VariantResult& curl = variant(SteeredBy::kPath, NoiseKind::kCurl);
  EXPECT_LT(curl.most(&Measures::turning_high), 0.1);
  // Features of about scale at about cruise speed: a few a second, and 50 Hz is the end of the spectrum.
  EXPECT_LT(curl.most(&Measures::turning_hz), 10);
}

TEST(Comparison, SaysWhatItMeasured) {
  const NoiseComparison& comparison = small();
  EXPECT_THAT(comparison.variants, SizeIs(10));
  const std::string text = to_text(comparison);
  for (const MeasureInfo& info : kMeasures) {
    EXPECT_THAT(text, HasSubstr(std::string(info.title)));
  }
  EXPECT_THAT(text, HasSubstr("path  curl"));
  EXPECT_THAT(text, HasSubstr("crowd random"));
  for (const Verdict& verdict : comparison.verdicts) {
    EXPECT_THAT(text, HasSubstr(std::string(verdict.holds() ? "holds" : "DOES NOT")));
    EXPECT_THAT(text, HasSubstr(verdict.claim));
  }
}

TEST(Comparison, JsonHasEveryVariantMeasureAndVerdict) {
  const auto json = nlohmann::json::parse(to_json(small()));
  EXPECT_EQ(json.at("bench"), "noise");
  EXPECT_EQ(json.at("agents"), 120);
  EXPECT_EQ(json.at("seeds"), 2);
  EXPECT_EQ(json.at("variants").size(), 10U);
  for (const auto& one : json.at("variants")) {
    EXPECT_TRUE(one.at("model").is_string());
    EXPECT_TRUE(one.at("noise").is_string());
    for (const MeasureInfo& info : kMeasures) {
      const auto& value = one.at(std::string(info.key));
      EXPECT_LE(value.at("least"), value.at("mean")) << info.key;
      EXPECT_LE(value.at("mean"), value.at("most")) << info.key;
    }
  }
  EXPECT_EQ(json.at("verdicts").size(), small().verdicts.size());
  for (const auto& verdict : json.at("verdicts")) {
    EXPECT_TRUE(verdict.at("holds").is_boolean());
  }
}

TEST(Comparison, IsDrawn) {
  EXPECT_THAT(draw_figure(small()).value(), StartsWith("\x89PNG"));
}

TEST(Verdict, HoldsOnItsSideOfTheBound) {
  EXPECT_TRUE((Verdict{"", 2.0, true, 2.0}).holds());
  EXPECT_FALSE((Verdict{"", 1.9, true, 2.0}).holds());
  EXPECT_TRUE((Verdict{"", 1.9, false, 2.0}).holds());
  EXPECT_FALSE((Verdict{"", NAN, true, 2.0}).holds());
  EXPECT_FALSE((Verdict{"", NAN, false, 2.0}).holds());
}

}  // namespace
}  // namespace mayfly::bench
