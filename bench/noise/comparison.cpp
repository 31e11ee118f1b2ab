#include "bench/noise/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/noise/verdicts.hpp"
#include "fields/parallel.hpp"

namespace mayfly::bench {
namespace {

constexpr std::size_t kPaths = 60;

std::vector<VariantResult> all_variants() {
  std::vector<VariantResult> variants;
  for (const SteeredBy model : {SteeredBy::kPath, SteeredBy::kBoids, SteeredBy::kCrowd}) {
    for (const NoiseKind noise :
         {NoiseKind::kNone, NoiseKind::kCurl, NoiseKind::kPerlin, NoiseKind::kWhite}) {
      if (noise != NoiseKind::kCurl || model == SteeredBy::kPath) {
        variants.push_back({model, noise, {}, {}, 0, {}, {}});
      }
    }
  }
  return variants;
}

void keep_picture(const Flown& flown, VariantResult& variant) {
  variant.paths = std::min(kPaths, flown.agents);
  for (std::size_t tick = 0; tick <= flown.ticks(); tick += VariantResult::kTicksARow) {
    for (std::size_t path = 0; path < variant.paths; ++path) {
      variant.path_rows.push_back(flown.places(tick)[path * flown.agents / variant.paths]);
    }
  }
  const auto ends = flown.places(flown.ticks());
  variant.ends.assign(ends.begin(), ends.end());
}

}  // namespace

double VariantResult::mean(double Measures::*member) const {
  double sum = 0.0;
  for (const Measures& seed : seeds) {
    sum += seed.*member;
  }
  return seeds.empty() ? 0.0 : sum / static_cast<double>(seeds.size());
}

double VariantResult::least(double Measures::*member) const {
  double least = INFINITY;
  for (const Measures& seed : seeds) {
    least = std::min(least, seed.*member);
  }
  return least;
}

double VariantResult::most(double Measures::*member) const {
  double most = -INFINITY;
  for (const Measures& seed : seeds) {
    most = std::max(most, seed.*member);
  }
  return most;
}

std::string_view name_of(SteeredBy model) {
  switch (model) {
    case SteeredBy::kBoids:
      return "boids";
    case SteeredBy::kCrowd:
      return "crowd";
    default:
      return "path";
  }
}

std::string_view name_of(NoiseKind noise) {
  switch (noise) {
    case NoiseKind::kCurl:
      return "curl";
    case NoiseKind::kPerlin:
      return "perlin";
    case NoiseKind::kWhite:
      return "random";
    case NoiseKind::kGaussian:
      return "gaussian";
    default:
      return "none";
  }
}

tl::expected<NoiseComparison, std::vector<Error>> compare_noises(const NoisePlan& plan) {
  const auto start = std::chrono::steady_clock::now();
  const auto arena = make_arena();
  if (!arena) {
    return tl::unexpected(arena.error());
  }
  NoiseComparison comparison{plan, all_variants(), {}, 0.0};
  const auto seeds = static_cast<std::size_t>(plan.seeds);
  const auto ticks = static_cast<std::size_t>(std::lround(plan.duration_s / kPeriod));
  for (VariantResult& variant : comparison.variants) {
    variant.seeds.resize(seeds);
  }
  const auto cruise = static_cast<double>(arena->field.cruise_speed);
  fields::parallel_for(
      comparison.variants.size() * seeds, plan.threads, "flights", plan.progress, [&](std::size_t i) {
        VariantResult& variant = comparison.variants[i / seeds];
        const std::size_t seed = i % seeds;
        const Flown flown = fly_model(*arena, variant.model, variant.noise, plan.agents, ticks, seed + 1);
        Measured measured = measure(flown, cruise);
        variant.seeds[seed] = measured.measures;
        if (seed == 0) {
          variant.curves = std::move(measured.curves);
          keep_picture(flown, variant);
        }
      });
  comparison.verdicts = judge(comparison.variants);
  comparison.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return comparison;
}

}  // namespace mayfly::bench
