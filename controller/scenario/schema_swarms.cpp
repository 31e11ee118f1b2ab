// The rows of who flies, and what moves them.
#include <string>

#include "controller/scenario/schema_rows.hpp"

namespace mayfly {
namespace {

using Rows = std::vector<Key>;

void add_noise_rows(Rows& rows, const std::string& path) {
  rows.push_back(
      {.path = path, .type = KeyType::kMap, .text = "The noise that makes paths natural (Wang14 §4)."});
  rows.push_back({.path = path + ".kind",
                  .type = KeyType::kChoice,
                  .fallback = "curl",
                  .choices = {"curl", "none", "perlin", "white", "gaussian"},
                  .text =
                      "Which noise; `curl` is free of divergence, the others are there to compare it with "
                      "and as fast in the rms."});
  rows.push_back(
      {.path = path + ".hash",
       .type = KeyType::kChoice,
       .fallback = "integer",
       .choices = {"integer", "perlin2002"},
       .text = "How lattice gradients are picked: by an integer hash, or by Perlin's published table."});
  const auto octave = [&](const std::string& at, const std::string& scale, const std::string& gain) {
    rows.push_back({.path = at + ".scale",
                    .type = KeyType::kNumber,
                    .unit = "m",
                    .min = 0.001,
                    .max = 1e4,
                    .required = scale.empty(),
                    .fallback = scale,
                    .text = "The length over which the noise changes."});
    rows.push_back({.path = at + ".gain",
                    .type = KeyType::kNumber,
                    .unit = "m²/s",
                    .min = 0.0,
                    .max = 1e4,
                    .required = gain.empty(),
                    .fallback = gain,
                    .text = "The height of the potential; noise speed is about 1.7 · gain / scale. To the "
                            "model `forces` noise is a force: m²/s²."});
  };
  octave(path, "0.4", "0.25");
  rows.push_back({.path = path + ".drift",
                  .type = KeyType::kNumber,
                  .unit = "m/s",
                  .min = 0.0,
                  .max = 1000.0,
                  .fallback = "0",
                  .text = "How fast the noise changes in time: its potentials drift along different axes."});
  rows.push_back(
      {.path = path + ".octaves",
       .type = KeyType::kList,
       .max = 4,
       .text = "Several potentials that are added (Wang14 Eq. 1), instead of `scale` and `gain`."});
  rows.push_back({.path = path + ".octaves[]", .type = KeyType::kMap, .text = "One potential."});
  octave(path + ".octaves[]", "", "");
}

void add_cost_rows(Rows& rows, const std::string& path) {
  rows.push_back({.path = path,
                  .type = KeyType::kMap,
                  .text = "What the way to the goal costs: length and nearness to obstacles (Wang14 §5.2)."});
  rows.push_back(
      {.path = path + ".preset",
       .type = KeyType::kChoice,
       .fallback = "wang14_eq4",
       .choices = {"wang14_eq4", "wang14_eq7"},
       .text = "Wang14 Eq. 4 weighs length 0.6 and repulsion 0.4; Eq. 7 weighs length by the cell's side "
               "and repulsion 4."});
  rows.push_back({.path = path + ".length_weight",
                  .type = KeyType::kNumber,
                  .unit = "1/m",
                  .min = 0.0,
                  .max = 1e6,
                  .above_min = true,
                  .fallback_text = "the preset's",
                  .text = "The cost of a metre."});
  rows.push_back({.path = path + ".repulsion_weight",
                  .type = KeyType::kNumber,
                  .unit = "1/m",
                  .min = 0.0,
                  .max = 1e6,
                  .fallback_text = "the preset's",
                  .text = "The cost of a metre right at an obstacle, on top of its length."});
  rows.push_back({.path = path + ".influence",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = kFarthest,
                  .above_min = true,
                  .fallback_text = "2·√2 cells",
                  .text = "How far from an obstacle its repulsion reaches (Wang14 Eq. 6)."});
  rows.push_back({.path = path + ".density_weight",
                  .type = KeyType::kNumber,
                  .unit = "m²",
                  .min = 0.0,
                  .max = 1e6,
                  .fallback = "0",
                  .text = "The cost of a metre for each agent in a m³, so that a crowd spreads; 0 is off."});
}

void add_limit_rows(Rows& rows, const std::string& path) {
  rows.push_back({.path = path, .type = KeyType::kMap, .text = "What the agents can do."});
  rows.push_back({.path = path + ".speed",
                  .type = KeyType::kNumber,
                  .unit = "m/s",
                  .min = 0.0,
                  .max = 1000.0,
                  .above_min = true,
                  .fallback = "3",
                  .text = "No agent is told to fly faster."});
  rows.push_back({.path = path + ".acceleration",
                  .type = KeyType::kNumber,
                  .unit = "m/s²",
                  .min = 0.0,
                  .max = 1e5,
                  .above_min = true,
                  .fallback = "20",
                  .text = "No agent is told to change its velocity faster."});
  rows.push_back({.path = path + ".separation",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = 1000.0,
                  .fallback_text = "0.2, or two radii and tubes where they are more",
                  .text =
                      "The least distance of two agents' centres, as the planner keeps it; below two radii "
                      "and two tubes the governor keeps more, and the scenario is refused."});
}

void add_governor_rows(Rows& rows, const std::string& path) {
  rows.push_back({.path = path + ".braking",
                  .type = KeyType::kNumber,
                  .unit = "m/s²",
                  .min = 0.0,
                  .max = 1e5,
                  .above_min = true,
                  .fallback_text = "the acceleration",
                  .text = "What the governor counts on for stopping; at most the acceleration."});
  rows.push_back({.path = path + ".tube",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = 100.0,
                  .fallback = "0",
                  .text = "How far a robot may be from where the governor takes it to be: pose noise and "
                          "tracking. Kept from everything besides the radius, and watched; 0 does neither."});
  rows.push_back(
      {.path = path + ".latency",
       .type = KeyType::kNumber,
       .unit = "s",
       .min = 0.0,
       .max = 1.0,
       .fallback = "0",
       .text = "A command takes effect after this time at the latest; at most 8 control periods."});
  rows.push_back({.path = path + ".watchdog",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 100.0,
                  .fallback = "0",
                  .text =
                      "How long a robot flies on when it hears nothing, before it brakes by itself: room is "
                      "kept for that. At most what it flies over a separation in. A command lives for 2.5 "
                      "control periods, so room for 1.5 of them is kept in any case: only a robot whose own "
                      "watchdog takes longer needs this."});
  rows.push_back({.path = path + ".downwash",
                  .type = KeyType::kNumber,
                  .min = 1.0,
                  .max = 100.0,
                  .fallback = "1",
                  .text = "Two robots above each other keep this many times the distance of two beside each "
                          "other; about 3 for small multirotors."});
}

void add_body_rows(Rows& rows, const std::string& at) {
  rows.push_back({.path = at + ".radius",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = 100.0,
                  .above_min = true,
                  .fallback = "0.05",
                  .text = "The radius of one agent's body."});
  rows.push_back({.path = at + ".mde_sweeps",
                  .type = KeyType::kInteger,
                  .min = 0,
                  .max = 1000,
                  .fallback = "8",
                  .text = "How often a tick, at most, minimum-distance enforcement goes over all pairs."});
  rows.push_back({.path = at + ".governor",
                  .type = KeyType::kFlag,
                  .fallback = "on",
                  .text = "The last safety stage; `off` is for swarms of which every robot is simulated."});
  rows.push_back({.path = at + ".robots",
                  .type = KeyType::kName,
                  .fallback_text = "the HAL, where there is only one",
                  .list_later = true,
                  .text = "The HAL that owns the swarm's robots, a name of `hal`."});
}

}  // namespace

void add_swarm_rows(Rows& rows) {
  const std::string at = "swarms[]";
  rows.push_back({.path = "swarms",
                  .type = KeyType::kList,
                  .max = 100,
                  .required = true,
                  .text = "Who flies; at least one swarm."});
  rows.push_back({.path = at, .type = KeyType::kMap, .text = "One swarm."});
  rows.push_back({.path = at + ".name",
                  .type = KeyType::kName,
                  .required = true,
                  .text = "What other keys, summaries and --set call it."});
  rows.push_back({.path = at + ".count",
                  .type = KeyType::kInteger,
                  .min = 1,
                  .max = 2e6,
                  .required = true,
                  .text = "How many agents."});
  rows.push_back({.path = at + ".start",
                  .type = KeyType::kMap,
                  .required = true,
                  .text = "The region agents start in: a box or a sphere."});
  add_shape_rows(rows, at + ".start", ShapeSet::kStart);
  rows.push_back({.path = at + ".goal",
                  .type = KeyType::kName,
                  .fallback_text = "required by the models `field` and `orca`",
                  .text = "A name of `world.goals`. Other models are not led to it: it is where they are "
                          "said to have got to."});
  rows.push_back({.path = at + ".at_goal",
                  .type = KeyType::kChoice,
                  .fallback = "rest",
                  .choices = {"rest", "roam"},
                  .text =
                      "What agents do in their goal: `rest`, each at a place of its own, or `roam` there, "
                      "moved by noise alone and led back when they leave (Wang14's aggregation)."});
  rows.push_back({.path = at + ".model",
                  .type = KeyType::kChoice,
                  .fallback = "field",
                  .choices = {"field", "forces", "boids", "orca", "brownian"},
                  .later = {"shape", "pso"},
                  .text = "What moves the agents: fields that lead to the goal, with noise (Wang14); forces "
                          "between them (BSwarm15); Reynolds' rules; fields without noise, with collision "
                          "avoidance; or chance (Schweitzer 1998)."});
  rows.push_back(
      {.path = at + ".preset",
       .type = KeyType::kText,
       .text = "A file of config/presets, without its ending, whose keys are this swarm's defaults."});
  add_model_rows(rows, at);
  add_noise_rows(rows, at + ".noise");
  add_cost_rows(rows, at + ".cost");
  rows.push_back({.path = at + ".cruise_speed",
                  .type = KeyType::kNumber,
                  .unit = "m/s",
                  .min = 0.0,
                  .max = 1000.0,
                  .fallback = "1.5",
                  .text = "The speed toward the goal, before noise (Wang14's s0)."});
  rows.push_back({.path = at + ".boundary",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = 1000.0,
                  .above_min = true,
                  .fallback_text = "one cell",
                  .text = "From this distance on, obstacles no longer bend the noise (Wang14's d0)."});
  add_limit_rows(rows, at + ".limits");
  add_governor_rows(rows, at + ".limits");
  add_body_rows(rows, at);
}

}  // namespace mayfly
