#include "bench/fields/measure.hpp"

#include <chrono>

namespace mayfly::bench {
namespace {

// A failure of one part in the terms of the whole.
tl::expected<void, std::vector<Error>> as_list(Result<void> result) {
  if (!result) {
    return tl::unexpected(std::vector{std::move(result.error())});
  }
  return {};
}

}  // namespace

tl::expected<Report, std::vector<Error>> measure_fields(const FieldsPlan& plan) {
  const auto start = std::chrono::steady_clock::now();
  Report report{.bench = "fields", .title = "The field core", .rows = {}, .curves = {}};
  const auto tell = [&](std::string_view stage, double fraction) {
    if (plan.progress) {
      plan.progress(stage, fraction);
    }
  };
  tell("noise", 0.0);
  auto done = as_list(measure_noise(plan, report))
                  .and_then([&] {
                    tell("solvers", 0.1);
                    return as_list(measure_solvers(plan, report));
                  })
                  .and_then([&] {
                    tell("engines", 0.4);
                    return measure_engines(plan, report);
                  })
                  .and_then([&] {
                    tell("growth", 0.7);
                    return measure_growth(plan, report);
                  });
  if (!done) {
    return tl::unexpected(std::move(done.error()));
  }
  report.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace mayfly::bench
