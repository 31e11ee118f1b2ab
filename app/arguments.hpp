// The command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "controller/scenario/override.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/result.hpp"

namespace mayfly::app {

enum class EngineChoice { kNative, kOpenCl, kAuto };

struct RunOptions {
  std::filesystem::path scenario;
  std::string hal;  // empty: the one that the scenario names
  EngineChoice engine = EngineChoice::kNative;
  std::vector<Override> overrides;     // --seed and --duration are among them
  std::vector<std::string> sets;       // the same as they were typed
  std::optional<GuardPlace> guard;     // empty: as the scenario says
  std::filesystem::path guard_report;  // empty: not wanted
  bool fast = false;
  std::filesystem::path record, summary, plot;  // empty: not wanted
  int threads = 0;                              // 0: as many as are worth it
  bool verbose = false;
  bool quiet = false;
};

struct CheckOptions {
  std::vector<std::filesystem::path> scenarios;
  std::vector<Override> overrides;
  int threads = 0;
  bool verbose = false;
};

struct Seeds {
  std::uint64_t first = 1, last = 1;
};

struct TestOptions {
  std::vector<std::filesystem::path> scenarios;
  std::vector<Override> overrides;
  std::optional<Seeds> seeds;   // empty: each scenario's own
  std::filesystem::path junit;  // empty: not wanted
  int threads = 0;              // how many flights at a time; 0: one a processor
  bool verbose = false;
};

struct DoctorOptions {};

struct BenchOptions {
  std::string name;              // empty: list them
  bool json = false;             // instead of the table
  std::filesystem::path figure;  // empty: not wanted
  int threads = 0;               // 0: as many as are worth it
  // Smaller than the real thing, to try it.
  std::size_t agents = 0;   // 0: the benchmark's own
  double duration_s = 0.0;  // 0: the benchmark's own
  int seeds = 0;            // 0: the benchmark's own
  bool pairs = false;       // faults: every two at once
};

// Of the process that `run --guard process` starts: descriptors that it was handed down.
struct GuardOptions {
  std::filesystem::path scenario;
  std::string hal;
  std::vector<Override> overrides;
  int segment = -1;
  int planner = -1;
  std::filesystem::path guard_report;
  std::filesystem::path black_box;
  bool verbose = false;
};

using Command =
    std::variant<RunOptions, CheckOptions, TestOptions, DoctorOptions, BenchOptions, GuardOptions>;

// Where the command line itself asks for no more than text (--help) or is wrong, that has been printed, and
// the exit code comes back instead.
tl::expected<Command, int> parse_arguments(int argc, const char* const* argv);

}  // namespace mayfly::app
