#include "controller/scenario/schema_rows.hpp"

#include <string>

namespace mayfly {
namespace {

using Rows = std::vector<Key>;

void add_top_rows(Rows& rows) {
  rows.push_back({.path = "mayfly",
                  .type = KeyType::kInteger,
                  .min = 1,
                  .max = 1,
                  .required = true,
                  .text = "The version of this format."});
  rows.push_back({.path = "name",
                  .type = KeyType::kText,
                  .fallback_text = "the file's name",
                  .text = "What the run is called in summaries and recordings."});
  rows.push_back({.path = "seed",
                  .type = KeyType::kInteger,
                  .min = 0,
                  .max = 9007199254740991.0,
                  .fallback = "1",
                  .text = "Everything random follows from it: the same seed gives the same run."});
  rows.push_back({.path = "duration",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1e6,
                  .above_min = true,
                  .fallback = "60",
                  .text = "How long to fly, in simulated time."});
}

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
                    .text = "The height of the potential; noise speed is about 1.7 · gain / scale."});
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
                  .fallback_text = "0.2, or two radii where they are more",
                  .text = "The least distance of two agents' centres; below two radii, bodies touch."});
}

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
  rows.push_back(
      {.path = at + ".goal", .type = KeyType::kName, .required = true, .text = "A name of `world.goals`."});
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
                  .choices = {"field"},
                  .later = {"forces", "shape", "pso", "boids", "orca", "brownian"},
                  .text = "What moves the agents."});
  rows.push_back(
      {.path = at + ".preset",
       .type = KeyType::kText,
       .text = "A file of config/presets, without its ending, whose keys are this swarm's defaults."});
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

void add_run_rows(Rows& rows) {
  rows.push_back(
      {.path = "planners", .type = KeyType::kMap, .text = "What plans beside control, at rates of its own."});
  for (const std::string name : {"curl_noise", "pso"}) {
    rows.push_back({.path = "planners." + name,
                    .type = KeyType::kMap,
                    .text = name == "pso" ? "The particle-swarm planner; accepted, not flown yet."
                                          : "The noise field; evaluated at the control rate for now."});
    rows.push_back({.path = "planners." + name + ".rate",
                    .type = KeyType::kNumber,
                    .unit = "Hz",
                    .min = 0.01,
                    .max = 1e4,
                    .required = true,
                    .text = "How often it plans."});
  }
  rows.push_back({.path = "planners.fields",
                  .type = KeyType::kMap,
                  .text = "Fields that are solved again in flight, off the control loop."});
  rows.push_back({.path = "planners.fields.rate",
                  .type = KeyType::kNumber,
                  .unit = "Hz",
                  .min = 0.01,
                  .max = 1000.0,
                  .fallback = "5",
                  .text = "How often, where goals or obstacles move or density counts."});
  rows.push_back({.path = "control", .type = KeyType::kMap, .text = "The control loop."});
  rows.push_back({.path = "control.rate",
                  .type = KeyType::kNumber,
                  .unit = "Hz",
                  .min = 1.0,
                  .max = 1e4,
                  .fallback = "100",
                  .text = "Ticks a second."});
  rows.push_back({.path = "record", .type = KeyType::kMap, .text = "The recording."});
  rows.push_back({.path = "record.rate",
                  .type = KeyType::kNumber,
                  .unit = "Hz",
                  .min = 0.01,
                  .max = 1e4,
                  .fallback = "20",
                  .text = "Samples a second; at most the control rate."});
}

void add_hal_rows(Rows& rows) {
  const std::string at = "hal.*";
  rows.push_back({.path = "hal",
                  .type = KeyType::kNamedMap,
                  .required = true,
                  .text = "Where robots are, real or simulated, by name."});
  rows.push_back({.path = at, .type = KeyType::kMap, .text = "One HAL."});
  rows.push_back({.path = at + ".kind",
                  .type = KeyType::kChoice,
                  .required = true,
                  .choices = {"sim"},
                  .text = "What it is: `sim` is the simulated HAL."});
  rows.push_back(
      {.path = at + ".plant",
       .type = KeyType::kChoice,
       .fallback = "ideal",
       .choices = {"ideal", "velocity_lag", "double_integrator"},
       .text =
           "How a simulated robot answers: at once, with a first-order lag, or limited in acceleration."});
  rows.push_back({.path = at + ".time_constant",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1000.0,
                  .above_min = true,
                  .fallback = "0.1",
                  .text = "The lag of `velocity_lag`."});
  rows.push_back({.path = at + ".rate",
                  .type = KeyType::kNumber,
                  .unit = "Hz",
                  .min = 1.0,
                  .max = 1e5,
                  .fallback_text = "the least multiple of `control.rate` from 200 up",
                  .text = "Plant steps a second; at least the control rate."});
  rows.push_back({.path = at + ".pose_noise",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = 100.0,
                  .fallback = "0",
                  .text = "Standard deviation of each measured coordinate."});
  rows.push_back({.path = at + ".delay",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 10.0,
                  .fallback = "0",
                  .text = "Time between measuring a pose and handing it over."});
  const auto chance = [&](const std::string& name, const std::string& unit, const std::string& text) {
    rows.push_back({.path = at + "." + name,
                    .type = KeyType::kNumber,
                    .unit = unit,
                    .min = 0.0,
                    .max = 1.0,
                    .fallback = "0",
                    .text = text});
  };
  chance("dropout", "", "Probability that one robot's pose of one tick is lost.");
  chance("freeze", "1/s",
         "Probability, a robot and a second, that its pose stays what it was for `freeze_time`.");
  rows.push_back({.path = at + ".freeze_time",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1000.0,
                  .above_min = true,
                  .fallback = "0.5",
                  .text = "How long a frozen pose stays."});
  chance("nan", "", "Probability that one robot's pose of one tick is not a number.");
}

}  // namespace

std::vector<Key> schema_rows() {
  Rows rows;
  add_top_rows(rows);
  add_world_rows(rows);
  add_swarm_rows(rows);
  add_stimulus_rows(rows);
  add_run_rows(rows);
  add_hal_rows(rows);
  add_expect_rows(rows);
  return rows;
}

}  // namespace mayfly
