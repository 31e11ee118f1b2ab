#include "app/bench_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "app/exit_code.hpp"
#include "app/log.hpp"
#include "app/progress_line.hpp"
#include "bench/faults/matrix.hpp"
#include "bench/fields/measure.hpp"
#include "bench/forces/measure.hpp"
#include "bench/governor/measure.hpp"
#include "bench/guard/measure.hpp"
#include "bench/noise/report.hpp"
#include "controller/scenario/suggest.hpp"
#include "record/output_file.hpp"

namespace mayfly::app {
namespace {

// What a benchmark came to: the text to print and, where one was asked for, a PNG.
struct Findings {
  std::string text, figure;
};
using BenchResult = tl::expected<Findings, std::vector<Error>>;

BenchResult bench_noise(const BenchOptions& options, const Progress& progress) {
  mayfly::bench::NoisePlan plan;
  plan.agents = options.agents > 0 ? options.agents : plan.agents;
  plan.duration_s = options.duration_s > 0.0 ? options.duration_s : plan.duration_s;
  plan.seeds = options.seeds > 0 ? options.seeds : plan.seeds;
  plan.threads = options.threads;
  plan.progress = progress;
  const auto comparison = mayfly::bench::compare_noises(plan);
  if (!comparison) {
    return tl::unexpected(comparison.error());
  }
  Findings findings{options.json ? to_json(*comparison) : to_text(*comparison), {}};
  if (!options.figure.empty()) {
    auto drawn = draw_figure(*comparison);
    if (!drawn) {
      return tl::unexpected(std::vector{std::move(drawn.error())});
    }
    findings.figure = std::move(*drawn);
  }
  return findings;
}

BenchResult findings_of(const mayfly::bench::Report& report, const BenchOptions& options) {
  Findings findings{options.json ? to_json(report) : to_text(report), {}};
  if (!options.figure.empty()) {
    auto drawn = draw_figure(report);
    if (!drawn) {
      return tl::unexpected(std::vector{std::move(drawn.error())});
    }
    findings.figure = std::move(*drawn);
  }
  return findings;
}

BenchResult bench_fields(const BenchOptions& options, const Progress& progress) {
  mayfly::bench::FieldsPlan plan;
  plan.most_agents = options.agents > 0 ? options.agents : plan.most_agents;
  plan.threads = options.threads > 0 ? options.threads : plan.threads;
  if (options.agents > 0 && options.agents < 10'000) {  // a trial: the solvers' worlds are small as well
    plan.largest_grid = 100;
    plan.torus_triangles = 7000;
  }
  plan.progress = progress;
  const auto report = mayfly::bench::measure_fields(plan);
  if (!report) {
    return tl::unexpected(report.error());
  }
  return findings_of(*report, options);
}

BenchResult bench_forces(const BenchOptions& options, const Progress& progress) {
  mayfly::bench::ForcesPlan plan;
  plan.most_agents = options.agents > 0 ? options.agents : plan.most_agents;
  plan.threads = options.threads > 0 ? options.threads : plan.threads;
  plan.progress = progress;
  const auto report = mayfly::bench::measure_forces(plan);
  if (!report) {
    return tl::unexpected(std::vector{report.error()});
  }
  return findings_of(*report, options);
}

BenchResult bench_faults(const BenchOptions& options, const Progress& progress) {
  mayfly::bench::FaultsPlan plan;
  plan.seeds = options.seeds > 0 ? static_cast<std::uint64_t>(options.seeds) : plan.seeds;
  plan.pairs = options.pairs;
  plan.threads = options.threads;
  plan.progress = progress;
  const auto matrix = mayfly::bench::sweep_faults(plan);
  if (!matrix) {
    return tl::unexpected(std::vector{matrix.error()});
  }
  return Findings{options.json ? to_json(*matrix) : to_text(*matrix), {}};
}

BenchResult bench_governor(const BenchOptions& options, const Progress& progress) {
  mayfly::bench::GovernorPlan plan;
  plan.attack_s = options.duration_s > 0.0 ? options.duration_s : plan.attack_s;
  plan.goals_s = std::min(plan.goals_s, plan.attack_s);
  plan.progress = progress;
  const auto report = mayfly::bench::measure_governor(plan);
  if (!report) {
    return tl::unexpected(std::vector{report.error()});
  }
  return findings_of(*report, options);
}

BenchResult bench_guard(const BenchOptions& options, const Progress& progress) {
  mayfly::bench::GuardPlan plan;
  plan.most_agents = options.agents > 0 ? options.agents : plan.most_agents;
  plan.ticks =
      options.duration_s > 0.0 ? std::max(1, static_cast<int>(100.0 * options.duration_s)) : plan.ticks;
  plan.progress = progress;
  const auto report = mayfly::bench::measure_guard(plan);
  if (!report) {
    return tl::unexpected(std::vector{report.error()});
  }
  return findings_of(*report, options);
}

struct Benchmark {
  std::string name;
  std::string_view does;
  BenchResult (*run)(const BenchOptions&, const Progress&);
};

const std::array kBenchmarks{
    Benchmark{"faults", "Every fault, alone or in pairs, against swarms that are flown badly", bench_faults},
    Benchmark{"fields", "The field core: engines, solvers, how time grows (Wang14, sections 5 to 7)",
              bench_fields},
    Benchmark{"forces", "The force core: forces, collision avoidance, neighbours (BSwarm15)", bench_forces},
    Benchmark{"governor", "The governor under attack, what it costs in progress and in time", bench_governor},
    Benchmark{"guard", "What a tick of the guard costs, by its parts", bench_guard},
    Benchmark{"noise", "Perlin, random and curl noise in three models (Wang14, section 7.1)", bench_noise}};

int list_benchmarks() {
  for (const Benchmark& benchmark : kBenchmarks) {
    fmt::print("{:<10} {}\n", benchmark.name, benchmark.does);
  }
  return kSuccess;
}

int refuse_name(const std::string& name) {
  std::vector<std::string> names(kBenchmarks.size());
  std::transform(kBenchmarks.begin(), kBenchmarks.end(), names.begin(),
                 [](const Benchmark& b) { return b.name; });
  const std::vector<Error> errors{{.message = "bench: no benchmark of that name",
                                   .found = fmt::format("'{}'", name),
                                   .wanted = list_names(names),
                                   .suggestion = nearest_name(name, names)}};
  print_errors(errors);
  return kBadInput;
}

int refuse(const std::vector<Error>& errors) {
  print_errors(errors);
  return exit_code_of(errors.front());
}

}  // namespace

int bench(const BenchOptions& options) {
  set_up_log(false);
  if (options.name.empty()) {
    return list_benchmarks();
  }
  const auto benchmark = std::find_if(kBenchmarks.begin(), kBenchmarks.end(),
                                      [&](const Benchmark& b) { return b.name == options.name; });
  if (benchmark == kBenchmarks.end()) {
    return refuse_name(options.name);
  }
  // Opened first, so that a wrong path costs no benchmark.
  std::optional<record::OutputFile> figure;
  if (!options.figure.empty()) {
    auto opened = record::OutputFile::create(options.figure);
    if (!opened) {
      return refuse({std::move(opened.error())});
    }
    figure.emplace(std::move(*opened));
  }
  ProgressLine line(true);
  const auto findings = benchmark->run(options, line.stages());
  line.clear();
  if (!findings) {
    return refuse(findings.error());
  }
  std::fputs(findings->text.c_str(), stdout);
  if (figure) {
    if (!figure->write(findings->figure)) {
      return refuse({{Cause::kEnvironment, "cannot write " + options.figure.string()}});
    }
    if (auto named = figure->commit(); !named) {
      return refuse({std::move(named.error())});
    }
  }
  return kSuccess;
}

}  // namespace mayfly::app
