// All models with all noises, over several seeds, and what comes of it.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "bench/noise/measures.hpp"
#include "core/progress.hpp"

namespace mayfly::bench {

struct NoisePlan {
  std::size_t agents = 300;
  double duration_s = 45.0;
  int seeds = 3;
  int threads = 0;  // 0: all cores
  Progress progress{};
};

// A figure in the table, by its name there and in the JSON.
struct MeasureInfo {
  std::string_view key;
  double Measures::*member;
  std::string_view title;
  int digits;  // after the point
};

inline constexpr std::array<MeasureInfo, 11> kMeasures{{
    {"clumping", &Measures::clumping, "clumping", 2},
    {"clumping_peak", &Measures::clumping_peak, "peak", 2},
    {"density_variation", &Measures::density_variation, "variation", 2},
    {"near_share", &Measures::near_share, "< d_min", 3},
    {"tortuosity", &Measures::tortuosity, "tortuosity", 2},
    {"turning_rate", &Measures::turning_rate, "rad/s", 2},
    {"turning_hz", &Measures::turning_hz, "Hz", 1},
    {"turning_high", &Measures::turning_high, "> Nyq/2", 3},
    {"noise_reach", &Measures::noise_reach, "reach", 3},
    {"stuck_share", &Measures::stuck_share, "stuck", 3},
    {"progress", &Measures::progress, "progress", 2},
}};

struct VariantResult {
  static constexpr std::size_t kTicksARow = 2;
  SteeredBy model;
  NoiseKind noise;
  std::vector<Measures> seeds;  // one a seed
  Curves curves;                // of the first seed
  // Of the first seed, for a picture: some agents' places, a row for each tenth of a second, and where all
  // end.
  std::size_t paths = 0;
  std::vector<glm::vec3> path_rows;
  std::vector<glm::vec3> ends;

  double mean(double Measures::*member) const;
  double least(double Measures::*member) const;
  double most(double Measures::*member) const;
};

std::string_view name_of(SteeredBy model);
std::string_view name_of(NoiseKind noise);  // kWhite is "random"

// What Wang14 §7.1 says, and what was measured; the seed that speaks most against it counts.
struct Verdict {
  std::string claim;
  double value = 0.0;
  bool at_least = true;  // value ≥ bound is wanted, else ≤
  double bound = 0.0;
  bool holds() const { return at_least ? value >= bound : value <= bound; }
};

struct NoiseComparison {
  NoisePlan plan;
  std::vector<VariantResult> variants;
  std::vector<Verdict> verdicts;
  double took_s = 0.0;
};

tl::expected<NoiseComparison, std::vector<Error>> compare_noises(const NoisePlan& plan);

}  // namespace mayfly::bench
