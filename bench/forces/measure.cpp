#include "bench/forces/measure.hpp"

#include <array>
#include <chrono>
#include <string_view>
#include <utility>

namespace mayfly::bench {
namespace {

struct Part {
  std::string_view name;
  Result<void> (*measure)(const ForcesPlan&, Report&);
};

constexpr std::array kParts{Part{"forces", measure_force_rows}, Part{"avoidance", measure_avoidance_rows},
                            Part{"neighbours", measure_neighbour_rows},
                            Part{"phase transition", measure_phase_rows}};

}  // namespace

Result<Report> measure_forces(const ForcesPlan& plan) {
  const auto start = std::chrono::steady_clock::now();
  Report report{.bench = "forces", .title = "The force core", .rows = {}, .curves = {}};
  for (std::size_t part = 0; part < kParts.size(); ++part) {
    if (plan.progress) {
      plan.progress(kParts[part].name, static_cast<double>(part) / kParts.size());
    }
    if (auto done = kParts[part].measure(plan, report); !done) {
      return fail(std::move(done.error()));
    }
  }
  report.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace mayfly::bench
