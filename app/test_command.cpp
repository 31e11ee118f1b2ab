#include "app/test_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>

#include "app/exit_code.hpp"
#include "app/log.hpp"
#include "app/progress_line.hpp"
#include "controller/scenario/load.hpp"
#include "record/junit.hpp"
#include "record/output_file.hpp"
#include "simulate/fly_simulated.hpp"

namespace mayfly::app {
namespace {

// One scenario with one seed.
struct Job {
  std::filesystem::path file;
  std::optional<std::uint64_t> seed;  // empty: the scenario's own
};

struct Verdict {
  std::string scenario;
  std::uint64_t seed = 0;
  double flown_s = 0.0, wall_s = 0.0;
  std::size_t lines = 0;
  std::vector<std::string> broken;  // "collisions 2, wanted == 0"
  std::vector<Error> errors;        // why it did not fly
};

std::vector<Job> jobs_of(const TestOptions& options) {
  std::vector<Job> jobs;
  for (const std::filesystem::path& file : options.scenarios) {
    if (!options.seeds) {
      jobs.push_back({file, std::nullopt});
      continue;
    }
    for (std::uint64_t seed = options.seeds->first; seed <= options.seeds->last; ++seed) {
      jobs.push_back({file, seed});
    }
  }
  return jobs;
}

ScenarioResult load(const Job& job, const TestOptions& options) {
  std::vector<Override> overrides = options.overrides;
  if (job.seed) {
    overrides.push_back(*parse_override(fmt::format("seed={}", *job.seed)));
  }
  auto scenario = load_scenario(job.file, overrides);
  if (scenario && scenario->expect.empty()) {
    Error error{.message = "nothing is expected of this scenario", .wanted = "a list 'expect'"};
    error.place = Place{job.file.string(), 0, 0};
    return tl::unexpected(std::vector{std::move(error)});
  }
  return scenario;
}

Verdict fly_one(const Job& job, const TestOptions& options) {
  Verdict verdict;
  verdict.scenario = job.file.stem().string();
  verdict.seed = job.seed.value_or(0);
  const auto scenario = load(job, options);
  if (!scenario) {
    verdict.errors = scenario.error();
    return verdict;
  }
  verdict.scenario = scenario->name;
  verdict.seed = scenario->seed;
  const auto start = std::chrono::steady_clock::now();
  const auto summary = simulate::fly_simulated(*scenario);
  verdict.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!summary) {
    verdict.errors = summary.error();
    return verdict;
  }
  verdict.flown_s = summary->simulated_s;
  verdict.lines = summary->expect.size();
  for (const ExpectationResult& line : summary->expect) {
    if (!line.pass) {
      const std::string value = line.value ? fmt::format("{:.6g}", *line.value) : "not measured";
      verdict.broken.push_back(fmt::format("{} {}, wanted {}", line.name, value, line.wanted));
    }
  }
  return verdict;
}

// Flies the jobs on several threads and hands them over one after the other, in order.
class Workers {
 public:
  Workers(const std::vector<Job>& jobs, const TestOptions& options)
      : jobs_(jobs), options_(options), done_(jobs.size()) {
    const auto cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t wanted = options.threads > 0 ? static_cast<std::size_t>(options.threads) : cores;
    for (std::size_t i = 0; i < std::min(wanted, jobs.size()); ++i) {
      threads_.emplace_back([this] { work(); });
    }
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers() {
    for (std::thread& thread : threads_) {
      thread.join();
    }
  }

  Verdict wait_for(std::size_t job) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return done_[job].has_value(); });
    return std::move(*done_[job]);
  }

 private:
  void work() {
    for (std::size_t job = next_++; job < jobs_.size(); job = next_++) {
      Verdict verdict = fly_one(jobs_[job], options_);
      const std::lock_guard lock(mutex_);
      done_[job] = std::move(verdict);
      changed_.notify_all();
    }
  }

  const std::vector<Job>& jobs_;
  const TestOptions& options_;
  std::vector<std::optional<Verdict>> done_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::thread> threads_;
};

void tell(const Verdict& v) {
  if (!v.errors.empty()) {
    fmt::print("error  {} (seed {})\n", v.scenario, v.seed);
  } else if (v.broken.empty()) {
    fmt::print("pass   {} (seed {}): {} line{} held in {:.4g} s, flown in {:.2f} s\n", v.scenario, v.seed,
               v.lines, v.lines == 1 ? "" : "s", v.flown_s, v.wall_s);
  } else {
    fmt::print("FAIL   {} (seed {}): {}\n", v.scenario, v.seed, fmt::join(v.broken, "; "));
  }
  std::fflush(stdout);
  print_errors(v.errors);
}

record::JUnitCase junit_case(const Verdict& v) {
  record::JUnitCase one{
      v.scenario, fmt::format("seed {}", v.seed), v.wall_s, fmt::format("{}", fmt::join(v.broken, "; ")), {}};
  for (const Error& error : v.errors) {
    one.error += (one.error.empty() ? "" : "\n") + to_string(error);
  }
  return one;
}

// Bad input is what a caller can mend, so it is told before a machine's failure, and both before a broken
// line.
int worse(int code, const Verdict& v) {
  for (const Error& error : v.errors) {
    code = code == kBadInput ? code : static_cast<int>(exit_code_of(error));
  }
  return code == kSuccess && !v.broken.empty() ? static_cast<int>(kExpectationBroken) : code;
}

int refuse(const Error& error) {
  print_errors(std::span(&error, 1));
  return exit_code_of(error);
}

}  // namespace

int test(const TestOptions& options) {
  set_up_log(options.verbose);
  // Opened first, so that a wrong path costs no flight.
  std::optional<record::OutputFile> file;
  if (!options.junit.empty()) {
    auto opened = record::OutputFile::create(options.junit);
    if (!opened) {
      return refuse(opened.error());
    }
    file.emplace(std::move(*opened));
  }
  const std::vector<Job> jobs = jobs_of(options);
  std::vector<record::JUnitCase> cases;
  std::size_t passed = 0;
  int code = kSuccess;
  {
    ProgressLine line(true);
    Workers workers(jobs, options);
    for (std::size_t job = 0; job < jobs.size(); ++job) {
      line.show(fmt::format("{} of {}: {}", job + 1, jobs.size(), jobs[job].file.stem().string()));
      const Verdict verdict = workers.wait_for(job);
      line.clear();
      tell(verdict);
      cases.push_back(junit_case(verdict));
      passed += verdict.errors.empty() && verdict.broken.empty() ? 1U : 0U;
      code = worse(code, verdict);
    }
  }
  fmt::print("{} of {} passed\n", passed, jobs.size());
  if (file) {
    if (!file->write(record::to_junit("mayfly test", cases))) {
      return refuse({Cause::kEnvironment, "cannot write " + options.junit.string()});
    }
    if (auto named = file->commit(); !named) {
      return refuse(named.error());
    }
  }
  return code;
}

}  // namespace mayfly::app
