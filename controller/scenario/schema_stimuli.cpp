// The rows of what single agents answer to.
#include <string>

#include "controller/scenario/schema_rows.hpp"

namespace mayfly {
namespace {

using Rows = std::vector<Key>;

void add_name_and_place(Rows& rows, const std::string& path, const std::string& where) {
  rows.push_back(
      {.path = path + ".name", .type = KeyType::kName, .required = true, .text = "What `expect` calls it."});
  rows.push_back({.path = path + ".position",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = where});
}

void add_reach(Rows& rows, const std::string& path, const std::string& text) {
  rows.push_back({.path = path + ".reach",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = 2.0 * kFarthest,
                  .above_min = true,
                  .required = true,
                  .text = text});
}

void add_weight(Rows& rows, const std::string& path, bool required, const std::string& text) {
  rows.push_back({.path = path + ".weight",
                  .type = KeyType::kNumber,
                  .unit = "m/s²",
                  .min = 0.0,
                  .max = 1e6,
                  .required = required,
                  .fallback_text = required ? "" : "required where forces drive who sees it",
                  .text = text});
}

void add_lamp_rows(Rows& rows, const std::string& lamp) {
  rows.push_back({.path = lamp,
                  .type = KeyType::kMap,
                  .group = "stimulus",
                  .text = "A light: now and then an agent flies straight at it (Wang14 §6); forces draw to "
                          "it at all times (BSwarm15)."});
  add_name_and_place(rows, lamp, "Where it hangs.");
  add_reach(rows, lamp, "How far it is seen.");
  rows.push_back({.path = lamp + ".speed",
                  .type = KeyType::kNumber,
                  .unit = "m/s",
                  .min = 0.0,
                  .max = 1000.0,
                  .above_min = true,
                  .fallback_text = "required where fields lead who sees it",
                  .text = "The velocity toward it, on top of all others."});
  rows.push_back({.path = lamp + ".probability",
                  .type = KeyType::kNumber,
                  .min = 0.0,
                  .max = 1.0,
                  .fallback_text = "required where fields lead who sees it",
                  .text = "That an agent which sees it answers, at one tick."});
  add_weight(rows, lamp, false, "χ_res: the force toward it, of the model `forces`.");
}

void add_stimulus(Rows& rows, const std::string& path, const std::string& text) {
  rows.push_back({.path = path, .type = KeyType::kMap, .group = "stimulus", .text = text});
  add_name_and_place(rows, path, "Where it is, or where it starts.");
  add_reach(rows, path, "r_res: how far it is felt.");
  add_weight(rows, path, true, "χ_res: the force away from it or toward it.");
  add_path_rows(rows, path + ".path");
}

void add_ahead_rows(Rows& rows, const std::string& path) {
  rows.push_back({.path = path,
                  .type = KeyType::kMap,
                  .group = "stimulus",
                  .text = "Each agent's own, which moves ahead of it: a group mills (BSwarm15, bats)."});
  rows.push_back({.path = path + ".distance",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = kFarthest,
                  .above_min = true,
                  .required = true,
                  .text = "How far ahead."});
  rows.push_back({.path = path + ".turn",
                  .type = KeyType::kNumber,
                  .unit = "degrees",
                  .min = -180.0,
                  .max = 180.0,
                  .fallback = "0",
                  .text = "About the vertical, to the left of the agent's heading."});
  add_reach(rows, path, "r_res: at least `distance`, or nobody feels it.");
  add_weight(rows, path, true, "χ_res: the force toward it.");
}

}  // namespace

void add_stimulus_rows(std::vector<Key>& rows) {
  const std::string at = "stimuli[]";
  rows.push_back({.path = "stimuli",
                  .type = KeyType::kList,
                  .max = 1000,
                  .fallback = "[]",
                  .text = "What single agents answer to. All but lamps are for the model `forces`."});
  rows.push_back({.path = at, .type = KeyType::kMap, .text = "One stimulus: exactly one kind."});
  add_lamp_rows(rows, at + ".lamp");
  add_stimulus(rows, at + ".predator", "A hunter: agents flee it, each turned by an angle of its own.");
  add_stimulus(rows, at + ".food", "Food: agents fly straight to it.");
  add_stimulus(rows, at + ".mate", "A mate: agents fly straight to it.");
  add_ahead_rows(rows, at + ".ahead");
  add_swarm_of_row(rows, at);
}

}  // namespace mayfly
