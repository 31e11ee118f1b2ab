#include "controller/scenario/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <tuple>

#include "controller/scenario/build.hpp"
#include "controller/scenario/numbers.hpp"

namespace mayfly {
namespace {

constexpr double kDistance = 8.0;  // φ and its spline
constexpr double kGuide = 16.0;    // a direction and a cost
constexpr double kScratch = 16.0;  // of one solve: cost, slowness, sources, what is added

// Of what is there, for the fields: engines, agents and the recording want some too.
constexpr double kShare = 0.8;

std::string text_of(const char* file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

double cells_in(const glm::dvec3& size, double cell) {
  return std::ceil(size.x / cell) * std::ceil(size.y / cell) * std::ceil(size.z / cell);
}

// The least cell side, to two digits, with which the grid fits.
double cell_that_fits(const glm::dvec3& size, double bytes_per_cell, double most) {
  double cell = std::cbrt(size.x * size.y * size.z * bytes_per_cell / most);
  const double step = std::pow(10.0, std::floor(std::log10(cell)) - 1.0);
  cell = std::ceil(cell / step) * step;
  while (cells_in(size, cell) * bytes_per_cell > most) {
    cell += step;
  }
  return cell;
}

bool is_solved_in_flight(const Scenario& scenario) {
  const auto moves = [](const auto& spec) { return spec.path.has_value(); };
  return std::any_of(scenario.world.goals.begin(), scenario.world.goals.end(), moves) ||
         std::any_of(scenario.world.obstacles.begin(), scenario.world.obstacles.end(), moves) ||
         std::any_of(scenario.swarms.begin(), scenario.swarms.end(), [](const SwarmSpec& swarm) {
           return swarm.is_guided() && swarm.cost.density_weight > 0.0F;
         });
}

}  // namespace

double field_bytes_per_cell(const Scenario& scenario) {
  std::set<std::tuple<std::string, float, float, float, float>> guides;
  for (const SwarmSpec& swarm : scenario.swarms) {
    if (swarm.is_guided()) {
      guides.emplace(swarm.goal, swarm.cost.length_weight, swarm.cost.repulsion_weight,
                     swarm.cost.influence.value_or(0.0F), swarm.radius);
    }
  }
  const double kept = kDistance + kGuide * static_cast<double>(guides.size());
  // What is solved in flight is written beside what is flown by.
  return is_solved_in_flight(scenario) ? 2.0 * kept + kScratch * static_cast<double>(guides.size())
                                       : kept + kScratch;
}

std::optional<double> available_in(std::string_view meminfo) {
  constexpr std::string_view kKey = "MemAvailable:";
  const std::size_t at = meminfo.find(kKey);
  if (at == std::string_view::npos) {
    return std::nullopt;
  }
  std::string_view line = meminfo.substr(at + kKey.size());
  line = line.substr(0, line.find('\n'));
  const NumberText number = read_number(line);
  return number.value && number.rest == "kB" ? std::optional(1024.0 * *number.value) : std::nullopt;
}

std::optional<double> available_memory() {
  std::optional<double> available = available_in(text_of("/proc/meminfo"));
  const auto limit = read_number(text_of("/sys/fs/cgroup/memory.max")).value;  // the text "max" is none
  const auto used = read_number(text_of("/sys/fs/cgroup/memory.current")).value;
  if (limit && used) {
    available = std::min(available.value_or(*limit), std::max(0.0, *limit - *used));
  }
  return available;
}

// Of a nested grid only the coarse cells are known here; how many fine ones there are is known when they are
// laid out, and whoever does that looks again.
void check_memory(const Values& world, const Scenario& scenario, std::optional<double> available,
                  Findings& findings) {
  const WorldSpec& spec = scenario.world;
  const glm::dvec3 size = glm::dvec3(spec.bounds.max) - glm::dvec3(spec.bounds.min);
  const double bytes_per_cell = field_bytes_per_cell(scenario);
  const double cells = cells_in(size, static_cast<double>(spec.coarse_cell.value_or(spec.cell)));
  const double bytes = cells * bytes_per_cell;
  const double room = kShare * available.value_or(kMaxFieldBytes / kShare);
  const double most = std::min(kMaxFieldBytes, room);
  if (bytes <= most) {
    return;
  }
  const char* key = spec.coarse_cell ? "coarse_cell" : "cell";
  const std::string wanted = most > 0.0
                                 ? fmt::format("at most {:.3g} GB: a {} of {:.6g} m or more{}", most / 1e9,
                                               key, cell_that_fits(size, bytes_per_cell, most),
                                               spec.coarse_cell ? "" : ", or world.coarse_cell")
                                 : "a machine with more memory";
  findings.error(world.mark(key),
                 bytes > kMaxFieldBytes ? "the fields of these bounds and this cell are too large"
                                        : "the fields are larger than the memory that this machine has left",
                 fmt::format("{:.4g} cells of {:g} bytes, {:.0f} bytes in all ({:.3g} GB)", cells,
                             bytes_per_cell, bytes, bytes / 1e9),
                 wanted);
  findings.errors.back().cause = bytes > kMaxFieldBytes ? Cause::kCaller : Cause::kEnvironment;
}

}  // namespace mayfly
