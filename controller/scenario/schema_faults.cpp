// The rows of what goes wrong.
#include <fmt/format.h>

#include <string>

#include "controller/faults/fault_table.hpp"
#include "controller/scenario/schema_rows.hpp"

namespace mayfly {
namespace {

using Rows = std::vector<Key>;

// "0.5 for `link_degraded`, 0.3 for `weak_motor`"
std::string usual_sizes(FaultSize size) {
  std::string text;
  for (const FaultRow& row : fault_rows()) {
    if (row.size == size) {
      text += (text.empty() ? "" : ", ") + std::string(row.name) + " " + fmt::format("{:g}", row.usual_size);
    }
  }
  return text;
}

void add_size(Rows& rows, FaultSize size, double max, const std::string& text) {
  rows.push_back({.path = "faults[]." + std::string(key_of(size)),
                  .type = KeyType::kNumber,
                  .unit = std::string(unit_of(size)),
                  .min = 0.0,
                  .max = max,
                  .fallback_text = usual_sizes(size),
                  .needs = "what",
                  .text = text});
}

void add_random_rows(Rows& rows) {
  const std::string at = "faults[].random";
  rows.push_back({.path = at,
                  .type = KeyType::kMap,
                  .group = "fault",
                  .text = "Faults by chance: which, whom and when follow from the seed."});
  rows.push_back({.path = at + ".what",
                  .type = KeyType::kNames,
                  .fallback_text = "all that strike in flight",
                  .text = "Which of them."});
  rows.push_back({.path = at + ".count",
                  .type = KeyType::kInteger,
                  .min = 1,
                  .max = 1000,
                  .fallback = "1",
                  .text = "How many."});
  rows.push_back({.path = at + ".longest",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1e6,
                  .above_min = true,
                  .fallback = "2",
                  .text = "The longest that one goes on."});
}

}  // namespace

void add_fault_rows(Rows& rows) {
  const std::string at = "faults[]";
  rows.push_back({.path = "faults",
                  .type = KeyType::kList,
                  .max = 1000,
                  .fallback = "[]",
                  .text = "What goes wrong, to whom and when; simulated HALs only."});
  rows.push_back({.path = at, .type = KeyType::kMap, .text = "One fault: `what`, or several by chance."});
  rows.push_back({.path = at + ".what",
                  .type = KeyType::kChoice,
                  .choices = fault_names(),
                  .group = "fault",
                  .text = "What goes wrong; [faults](faults.md) says what each does."});
  rows.push_back({.path = at + ".robots",
                  .type = KeyType::kNames,
                  .fallback_text = "all",
                  .needs = "what",
                  .text = "Whom it strikes: a swarm, a robot such as `flies_3`, a list of them, or `all`."});
  rows.push_back({.path = at + ".at",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1e6,
                  .fallback = "0",
                  .needs = "what",
                  .text = "When it begins."});
  rows.push_back({.path = at + ".for",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1e6,
                  .above_min = true,
                  .fallback_text = "to the run's end",
                  .needs = "what",
                  .text = "How long it goes on."});
  add_size(rows, FaultSize::kShare, 1.0, "How much is lost, is left, or is missing.");
  add_size(rows, FaultSize::kDistance, 1000.0, "How far.");
  add_size(rows, FaultSize::kSpeed, 1e9, "How fast.");
  add_size(rows, FaultSize::kTime, 1000.0, "How long each time.");
  rows.push_back({.path = at + ".direction",
                  .type = KeyType::kVector,
                  .min = -1e6,
                  .max = 1e6,
                  .fallback_text = "level, by chance, another for each seed",
                  .needs = "what",
                  .text = "Of `wind`, `pose_jump`, `pose_ghost`, `start_too_near` and `start_outside`; of "
                          "any length but 0."});
  add_random_rows(rows);
}

}  // namespace mayfly
