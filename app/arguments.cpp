#include "app/arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <map>

#include "app/exit_code.hpp"
#include "controller/scenario/numbers.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly::app {
namespace {

// What the text on the command line is before it means something.
struct Raw {
  std::string seed, duration, seeds;
  std::vector<std::string> sets;
};

constexpr auto kExitCodes =
    "\nExit status: 0 success; 1 an `expect` line does not hold; 2 bad input; 3 the machine or a HAL "
    "failed;\n"
    "130 stopped by Ctrl-C.\n";

void add_sets(CLI::App& command, Raw& raw) {
  command.add_option("--set", raw.sets, "Change a value of the scenario; may be given again")
      ->type_name("path.to.key=value")
      ->allow_extra_args(false);
}

void add_threads(CLI::App& command, int& threads) {
  command
      .add_option("--threads", threads,
                  "Threads of the engine and the field builders; 0: chosen for this machine")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
}

void add_run(CLI::App& app, RunOptions& options, Raw& raw) {
  CLI::App& run = *app.add_subcommand("run", "Fly a scenario, in real time unless --fast");
  run.add_option("SCENARIO", options.scenario, "A scenario file (YAML)")->required();
  run.add_option("--hal", options.hal, "Fly every swarm on this HAL of the scenario")->type_name("NAME");
  const std::map<std::string, EngineChoice> engines{
      {"native", EngineChoice::kNative}, {"opencl", EngineChoice::kOpenCl}, {"auto", EngineChoice::kAuto}};
  run.add_option("--engine", options.engine,
                 "What computes the model: native, opencl, or auto: the one that is faster here")
      ->transform(CLI::Transformer(engines).description(""))
      ->type_name("native|opencl|auto")
      ->check(CLI::IsMember(std::vector{EngineChoice::kNative, EngineChoice::kOpenCl, EngineChoice::kAuto},
                            nullptr)
                  .description("")
                  .name("native|opencl|auto"));
  run.add_option("--seed", raw.seed, "Seed of everything random")->type_name("N");
  run.add_option("--duration", raw.duration, "Seconds to fly")->type_name("S");
  run.add_flag("--fast", options.fast,
               "On a virtual clock: as fast as the machine goes, the same bits every time");
  const std::map<std::string, GuardPlace> guards{{"inline", GuardPlace::kInline},
                                                 {"process", GuardPlace::kProcess}};
  run.add_option("--guard", options.guard,
                 "Where the guard runs: inline, or process: one of its own, which brings the robots to rest "
                 "whatever becomes of this one; the scenario's control.guard unless given")
      ->transform(CLI::Transformer(guards).description(""))
      ->type_name("inline|process")
      ->check(CLI::IsMember(std::vector{GuardPlace::kInline, GuardPlace::kProcess}, nullptr)
                  .description("")
                  .name("inline|process"));
  run.add_option("--guard-report", options.guard_report, "Write what the guard's process saw (JSON)")
      ->type_name("FILE");
  run.add_option("--record", options.record, "Write every agent's state and command (CSV)")
      ->type_name("FILE");
  run.add_option("--summary", options.summary, "Write what the flight came to (JSON)")->type_name("FILE");
  run.add_option("--plot", options.plot, "Draw the paths from above and from the side (PNG)")
      ->type_name("FILE");
  add_sets(run, raw);
  add_threads(run, options.threads);
  run.add_flag("-v,--verbose", options.verbose, "Say more, on stderr");
  run.add_flag("-q,--quiet", options.quiet, "Say nothing but errors");
  run.footer(
      std::string("\nExample:\n  mayfly run config/scenarios/two_blocks_passage.yaml --fast --plot out.png\n"
                  "  mayfly run config/scenarios/mesh_maze.yaml --fast --set swarms.flies.count=50\n") +
      kExitCodes);
}

void add_guard(CLI::App& app, GuardOptions& options, Raw& raw) {
  CLI::App& guard = *app.add_subcommand(
      "guard", "The process between a planner and its robots; started by `mayfly run --guard process`");
  guard.add_option("SCENARIO", options.scenario, "The planner's scenario file (YAML)")->required();
  guard.add_option("--hal", options.hal, "Fly every swarm on this HAL of the scenario")->type_name("NAME");
  guard.add_option("--segment", options.segment, "Descriptor of the shared memory, from the planner")
      ->type_name("FD")
      ->required();
  guard.add_option("--planner", options.planner, "Descriptor of the planner's process, from the planner")
      ->type_name("FD")
      ->required();
  guard.add_option("--guard-report", options.guard_report, "Write what was seen (JSON)")->type_name("FILE");
  guard.add_option("--black-box", options.black_box, "Where to write what the black box has kept (CSV)")
      ->type_name("FILE");
  add_sets(guard, raw);
  guard.add_flag("-v,--verbose", options.verbose, "Say more, on stderr");
  guard.footer(
      std::string("\nExample:\n  mayfly run config/scenarios/two_blocks_passage.yaml --guard process\n") +
      kExitCodes);
}

void add_check(CLI::App& app, CheckOptions& options, Raw& raw) {
  CLI::App& check =
      *app.add_subcommand("check", "Validate scenarios: schema, files, fields, limits; flies nothing");
  check.add_option("SCENARIO", options.scenarios, "Scenario files (YAML)")->required();
  add_sets(check, raw);
  add_threads(check, options.threads);
  check.add_flag("-v,--verbose", options.verbose, "Say more, on stderr");
  check.footer(std::string("\nExample:\n  mayfly check config/scenarios/*.yaml\n") + kExitCodes);
}

void add_test(CLI::App& app, TestOptions& options, Raw& raw) {
  CLI::App& test = *app.add_subcommand(
      "test", "Fly scenarios on a virtual clock and hold them to their `expect` lines, one line each");
  test.add_option("SCENARIO", options.scenarios, "Scenario files (YAML)")->required();
  test.add_option("--seeds", raw.seeds, "Fly each with every seed from A to B, both included")
      ->type_name("A..B");
  test.add_option("--junit", options.junit, "Write what came of it for a CI system (XML)")->type_name("FILE");
  add_sets(test, raw);
  test.add_option("--threads", options.threads, "How many flights at a time; 0: one a processor")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  test.add_flag("-v,--verbose", options.verbose, "Say more, on stderr");
  test.footer(std::string("\nExample:\n  mayfly test config/scenarios/faults/*.yaml --junit faults.xml\n"
                          "  mayfly test config/scenarios/faults/links.yaml --seeds 1..20\n") +
              kExitCodes);
}

void add_doctor(CLI::App& app) {
  app.add_subcommand("doctor", "What this machine has for flying, and how to get what is missing")
      ->footer("\nExample:\n  mayfly doctor\n");
}

void add_bench(CLI::App& app, BenchOptions& options) {
  CLI::App& bench =
      *app.add_subcommand("bench", "Measure the models against others; without a name, list what there is");
  bench.add_option("NAME", options.name, "What to measure");
  bench.add_flag("--json", options.json, "Print JSON instead of a table");
  bench.add_option("--figure", options.figure, "Draw it (PNG)")->type_name("FILE");
  bench.add_option("--agents", options.agents, "Other than the benchmark's own number")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  bench.add_option("--duration", options.duration_s, "Seconds to fly, other than the benchmark's own")
      ->type_name("S")
      ->check(CLI::Range(0.01, 36000.0));
  bench.add_option("--seeds", options.seeds, "How often, each with other random numbers")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  bench.add_flag("--pairs", options.pairs, "faults: every two at once instead of each alone");
  add_threads(bench, options.threads);
  bench.footer(
      std::string(
          "\nExample:\n  mayfly bench noise --figure noise.png\n  mayfly bench faults --seeds 100\n") +
      kExitCodes);
}

// A word that is no command, before CLI11 calls it an unexpected argument.
bool refuse_unknown_command(int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') {
    return false;
  }
  const std::string word = argv[1];
  const std::vector<std::string> there{"run", "check", "test", "guard", "doctor", "bench"};
  const std::array<std::string_view, 3> later{"plan", "emulate", "view"};
  if (std::find(there.begin(), there.end(), word) != there.end()) {
    return false;
  }
  const bool planned = std::find(later.begin(), later.end(), word) != later.end();
  const std::string near = planned ? "" : nearest_name(word, there);
  fmt::print(stderr, "mayfly: {} '{}'; wanted {}{}\n", planned ? "not available yet:" : "unknown command",
             word, list_names(there), near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
  return true;
}

// All that changes the scenario, as `--set` would.
std::vector<std::string> sets_of(const Raw& raw) {
  std::vector<std::string> texts = raw.sets;
  if (!raw.seed.empty()) {
    texts.push_back("seed=" + raw.seed);
  }
  if (!raw.duration.empty()) {
    texts.push_back("duration=" + raw.duration);
  }
  return texts;
}

Result<std::vector<Override>> overrides_of(const Raw& raw) {
  std::vector<Override> overrides;
  for (const std::string& text : sets_of(raw)) {
    auto parsed = parse_override(text);
    if (!parsed) {
      return fail(std::move(parsed.error()));
    }
    overrides.push_back(std::move(*parsed));
  }
  return overrides;
}

// "3..8", or "3".
Result<std::optional<Seeds>> seeds_of(const Raw& raw) {
  if (raw.seeds.empty()) {
    return std::nullopt;
  }
  const std::size_t dots = raw.seeds.find("..");
  const auto first = read_integer(raw.seeds.substr(0, dots));
  const auto last = dots == std::string::npos ? first : read_integer(raw.seeds.substr(dots + 2));
  constexpr long long kMost = 1'000'000;  // flights of one scenario
  if (!first || !last || *first < 0 || *last < *first || *last - *first >= kMost) {
    return fail({.message = "--seeds: these are no seeds",
                 .found = "'" + raw.seeds + "'",
                 .wanted = "A..B with A at most B, such as 1..20"});
  }
  return Seeds{static_cast<std::uint64_t>(*first), static_cast<std::uint64_t>(*last)};
}

int refuse(const Error& error) {
  fmt::print(stderr, "mayfly: {}\n", to_string(error));
  return kBadInput;
}

}  // namespace

tl::expected<Command, int> parse_arguments(int argc, const char* const* argv) {
  if (refuse_unknown_command(argc, argv)) {
    return tl::unexpected<int>(kBadInput);
  }
  CLI::App app("mayfly flies swarms of robots, real and simulated, by the models of insect swarms.",
               "mayfly");
  app.set_version_flag("--version", "mayfly " MAYFLY_VERSION);
  app.require_subcommand(1);
  app.footer(
      std::string("\nExample:\n  mayfly run config/scenarios/two_blocks_passage.yaml --fast --plot out.png\n"
                  "  mayfly COMMAND --help\n") +
      kExitCodes);
  RunOptions run;
  CheckOptions check;
  TestOptions test;
  BenchOptions bench;
  Raw raw;
  add_run(app, run, raw);
  add_check(app, check, raw);
  add_test(app, test, raw);
  GuardOptions guard;
  add_guard(app, guard, raw);
  add_doctor(app);
  add_bench(app, bench);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return tl::unexpected<int>(app.exit(error) == 0 ? kSuccess : kBadInput);
  }
  auto overrides = overrides_of(raw);
  if (!overrides) {
    return tl::unexpected<int>(refuse(overrides.error()));
  }
  if (app.got_subcommand("run")) {
    run.overrides = std::move(*overrides);
    run.sets = sets_of(raw);
    return Command(std::move(run));
  }
  if (app.got_subcommand("check")) {
    check.overrides = std::move(*overrides);
    return Command(std::move(check));
  }
  if (app.got_subcommand("test")) {
    auto seeds = seeds_of(raw);
    if (!seeds) {
      return tl::unexpected<int>(refuse(seeds.error()));
    }
    test.overrides = std::move(*overrides);
    test.seeds = *seeds;
    return Command(std::move(test));
  }
  if (app.got_subcommand("guard")) {
    guard.overrides = std::move(*overrides);
    return Command(std::move(guard));
  }
  if (app.got_subcommand("bench")) {
    return Command(std::move(bench));
  }
  return Command(DoctorOptions{});
}

}  // namespace mayfly::app
