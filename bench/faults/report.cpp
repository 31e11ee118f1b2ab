// The matrix for people and for programs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/faults/matrix.hpp"
#include "controller/safety/reaction_table.hpp"

namespace mayfly::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string name_of(const std::vector<FaultKind>& faults) {
  std::string name;
  for (const FaultKind kind : faults) {
    name += (name.empty() ? "" : " + ") + std::string(fault_row(kind).name);
  }
  return name;
}

// "20, 120 ms": in how many flights, and the longest.
std::string text_of(const Delays& delays) {
  return delays.count == 0 ? "-" : fmt::format("{}, {:.0f} ms", delays.count, 1e3 * delays.longest);
}

std::string text_of_ticks(const std::optional<std::uint64_t>& ticks) {
  return ticks ? fmt::format("{} tick{}", *ticks, *ticks == 1 ? "" : "s") : "-";
}

std::string text_of(const simulate::BreachCounts& breaches) {
  return fmt::format("{} {} {} {}", breaches[0], breaches[1], breaches[2], breaches[3]);
}

Json json_of(const Delays& delays) {
  return {{"flights", delays.count}, {"longest_s", delays.count > 0 ? Json(delays.longest) : Json()}};
}

Json json_of(const FaultCell& cell) {
  const FaultRow& row = fault_row(cell.faults.front());
  return {{"fault", name_of(cell.faults)},
          {"reaction", name_of(row.reaction)},
          {"bound", bound_text(row)},
          {"flights", cell.flights},
          {"seen", json_of(cell.seen)},
          {"unseen", cell.unseen},
          {"late", cell.late},
          {"safe_after_ticks", cell.safe_after ? Json(*cell.safe_after) : Json()},
          {"stopped", json_of(cell.stopped)},
          {"breaches",
           {{"separation", cell.breaches[0]},
            {"fence", cell.breaches[1]},
            {"speed", cell.breaches[2]},
            {"acceleration", cell.breaches[3]}}},
          {"suspended",
           {{"separation", cell.suspended[0]},
            {"fence", cell.suspended[1]},
            {"speed", cell.suspended[2]},
            {"acceleration", cell.suspended[3]}}},
          {"least_gap_m", std::isfinite(cell.least_gap) ? Json(cell.least_gap) : Json()},
          {"hung", cell.hung},
          {"first_bad_seed", cell.first_bad ? Json(*cell.first_bad) : Json()},
          {"hash", fmt::format("{:016x}", cell.hash)}};
}

}  // namespace

std::string to_text(const FaultMatrix& matrix) {
  std::size_t width = 5;
  for (const FaultCell& cell : matrix.cells) {
    width = std::max(width, name_of(cell.faults).size());
  }
  std::string text =
      fmt::format("{:<{}}  {:<11}  {:<17}  {:<14}  {:<4}  {:<7}  {:<14}  {:<12}  {:<14}  {:>9}  {}\n",
                  "fault", width, "at least", "within", "seen", "late", "safe", "told to stop", "breaches",
                  "suspended", "least gap", "hung");
  for (const FaultCell& cell : matrix.cells) {
    const FaultRow& row = fault_row(cell.faults.front());
    text += fmt::format(
        "{:<{}}  {:<11}  {:<17}  {:<14}  {:<4}  {:<7}  {:<14}  {:<12}  {:<14}  {:>7.3f} m  {}{}\n",
        name_of(cell.faults), width, mayfly::name_of(row.reaction), bound_text(row), text_of(cell.seen),
        cell.late, text_of_ticks(cell.safe_after), text_of(cell.stopped), text_of(cell.breaches),
        text_of(cell.suspended), cell.least_gap, cell.hung,
        cell.first_bad ? fmt::format("  seed {}", *cell.first_bad) : "");
  }
  text += fmt::format(
      "{} flights in {:.1f} s: {} breaches, {} hung, {} unseen, {} late, {} rows slow to a "
      "safe command; wanted none\n",
      matrix.flights, matrix.took_s, matrix.breaches, matrix.hung, matrix.unseen, matrix.late, matrix.slow);
  return text +
         "seen: in how many flights, and the longest from when the fault can be seen. told to stop: likewise "
         "from its begin.\nsafe: the most ticks from a symptom that holds somebody to the last safe command "
         "of all it is about. breaches: of\nseparation, fence, speed and acceleration. suspended: those of "
         "robots of which the guard had told that they do not go\nwhere they are told, or that nobody knows "
         "where they are.\n";
}

std::string to_json(const FaultMatrix& matrix) {
  Json cells = Json::array();
  for (const FaultCell& cell : matrix.cells) {
    cells.push_back(json_of(cell));
  }
  const Json document{{"bench", "faults"},           {"seeds", matrix.seeds}, {"flights", matrix.flights},
                      {"breaches", matrix.breaches}, {"hung", matrix.hung},   {"unseen", matrix.unseen},
                      {"late", matrix.late},         {"slow", matrix.slow},   {"took_s", matrix.took_s},
                      {"faults", std::move(cells)}};
  return document.dump(2) + "\n";
}

}  // namespace mayfly::bench
