#include "bench/noise/verdicts.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly::bench {
namespace {

const VariantResult& find(std::span<const VariantResult> variants, SteeredBy model, NoiseKind noise) {
  return *std::find_if(variants.begin(), variants.end(),
                       [&](const VariantResult& v) { return v.model == model && v.noise == noise; });
}

// Seed by seed a over b, where b may be as good as nothing.
std::vector<double> ratios(const VariantResult& a, const VariantResult& b, double Measures::*member) {
  std::vector<double> values;
  for (std::size_t seed = 0; seed < a.seeds.size(); ++seed) {
    values.push_back(a.seeds[seed].*member / std::max(b.seeds[seed].*member, 1e-4));
  }
  return values;
}

Verdict at_least(std::string claim, const std::vector<double>& values, double bound) {
  return {std::move(claim), *std::min_element(values.begin(), values.end()), true, bound};
}
Verdict at_most(std::string claim, const std::vector<double>& values, double bound) {
  return {std::move(claim), *std::max_element(values.begin(), values.end()), false, bound};
}

// White noise in the direction gives ½ + 1/π = 0.82 of its turning above half the Nyquist frequency, and
// carries √(period / 1 s) = 0.1 of what steady noise would.
constexpr double kVibrates = 0.5;

void judge_ours(std::span<const VariantResult> variants, std::vector<Verdict>& verdicts) {
  const auto& none = find(variants, SteeredBy::kPath, NoiseKind::kNone);
  const auto& curl = find(variants, SteeredBy::kPath, NoiseKind::kCurl);
  const auto& perlin = find(variants, SteeredBy::kPath, NoiseKind::kPerlin);
  const auto& random = find(variants, SteeredBy::kPath, NoiseKind::kWhite);
  verdicts.push_back(at_least("path: Perlin noise gathers agents, over curl noise (clumping)",
                              ratios(perlin, curl, &Measures::clumping), 1.5));
  verdicts.push_back(at_least("path: Perlin noise brings more nearer than d_min than curl noise does",
                              ratios(perlin, curl, &Measures::near_share), 3.0));
  verdicts.push_back(at_least("path: Perlin noise leaves agents stuck (share)",
                              {perlin.least(&Measures::stuck_share)}, 0.1));
  verdicts.push_back(
      at_most("path: curl noise leaves nobody stuck (share)", {curl.most(&Measures::stuck_share)}, 0.01));
  verdicts.push_back(at_most("path: curl noise gathers no more than no noise does (clumping)",
                             ratios(curl, none, &Measures::clumping), 1.1));
  verdicts.push_back(at_least("path: random noise just vibrates (turning above Nyquist/2)",
                              {random.least(&Measures::turning_high)}, kVibrates));
  verdicts.push_back(at_most("path: curl noise does not vibrate (turning above Nyquist/2)",
                             {curl.most(&Measures::turning_high)}, 0.1));
  verdicts.push_back(at_least("path: curl noise carries agents farther in 1 s than random noise",
                              ratios(curl, random, &Measures::noise_reach), 2.0));
}

void judge_other(std::span<const VariantResult> variants, SteeredBy model, std::vector<Verdict>& verdicts) {
  const auto& none = find(variants, model, NoiseKind::kNone);
  const auto& perlin = find(variants, model, NoiseKind::kPerlin);
  const auto& random = find(variants, model, NoiseKind::kWhite);
  const std::string name(name_of(model));
  verdicts.push_back(at_least(name + ": Perlin noise gathers agents, over no noise (clumping)",
                              ratios(perlin, none, &Measures::clumping), 1.5));
  verdicts.push_back(at_least(name + ": Perlin noise leaves agents stuck (share)",
                              {perlin.least(&Measures::stuck_share)}, 0.1));
  verdicts.push_back(at_least(name + ": random noise just vibrates (turning above Nyquist/2)",
                              {random.least(&Measures::turning_high)}, kVibrates));
}

}  // namespace

std::vector<Verdict> judge(std::span<const VariantResult> variants) {
  std::vector<Verdict> verdicts;
  judge_ours(variants, verdicts);
  judge_other(variants, SteeredBy::kBoids, verdicts);
  judge_other(variants, SteeredBy::kCrowd, verdicts);
  return verdicts;
}

}  // namespace mayfly::bench
