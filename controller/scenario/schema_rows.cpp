#include "controller/scenario/schema_rows.hpp"

#include <string>

namespace mayfly {
namespace {

using Rows = std::vector<Key>;

constexpr double kFarthest = 10'000.0;  // m from the origin, as in schema_shapes.cpp

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

void add_world_rows(Rows& rows) {
  rows.push_back(
      {.path = "world", .type = KeyType::kMap, .required = true, .text = "Where the swarm flies."});
  rows.push_back({.path = "world.bounds",
                  .type = KeyType::kMap,
                  .required = true,
                  .text = "The box that the fields cover; agents stay inside."});
  rows.push_back({.path = "world.bounds.min",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "The corner with the smallest coordinates."});
  rows.push_back({.path = "world.bounds.max",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "The corner with the largest coordinates, larger than `min` in all three."});
  rows.push_back({.path = "world.cell",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.001,
                  .max = 1000.0,
                  .fallback = "1.0",
                  .text = "The side of one cell of the grid that distance and cost are kept on."});
  rows.push_back({.path = "world.obstacles",
                  .type = KeyType::kList,
                  .max = 10'000,
                  .fallback = "[]",
                  .text = "What agents must not enter."});
  rows.push_back(
      {.path = "world.obstacles[]", .type = KeyType::kMap, .text = "One obstacle: exactly one shape."});
  add_shape_rows(rows, "world.obstacles[]", ShapeSet::kObstacle);
  rows.push_back({.path = "world.goals",
                  .type = KeyType::kNamedMap,
                  .required = true,
                  .text = "The places swarms fly to, by name."});
  rows.push_back({.path = "world.goals.*", .type = KeyType::kMap, .text = "One goal: exactly one shape."});
  add_shape_rows(rows, "world.goals.*", ShapeSet::kGoal);
}

void add_noise_rows(Rows& rows, const std::string& path) {
  rows.push_back(
      {.path = path, .type = KeyType::kMap, .text = "The noise that makes paths natural (Wang14 §4)."});
  rows.push_back({.path = path + ".kind",
                  .type = KeyType::kChoice,
                  .fallback = "curl",
                  .choices = {"curl", "none"},
                  .later = {"perlin", "white", "gaussian"},
                  .text = "Which noise; `curl` is divergence-free."});
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
  rows.push_back(
      {.path = path + ".octaves",
       .type = KeyType::kList,
       .max = 16,
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
                  .fallback = "0.2",
                  .text = "The least distance of two agents' centres."});
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
                  .text = "What agents do in their goal: `rest`, each at a place of its own, or `roam` there, "
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
  rows.push_back({.path = "stimuli",
                  .type = KeyType::kList,
                  .fallback = "[]",
                  .available = false,
                  .text = "Predators, mates and lamps."});
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

void add_expect_rows(Rows& rows) {
  const std::string at = "expect[]";
  rows.push_back({.path = "expect",
                  .type = KeyType::kList,
                  .max = 1000,
                  .fallback = "[]",
                  .text = "What the run must show; a run that breaks one exits with 1."});
  rows.push_back({.path = at, .type = KeyType::kMap, .text = "One expectation: exactly one quantity."});
  rows.push_back({.path = at + ".reached",
                  .type = KeyType::kMap,
                  .group = "quantity",
                  .text = "How many agents entered their goal at any time."});
  rows.push_back({.path = at + ".reached.swarm",
                  .type = KeyType::kName,
                  .fallback_text = "all swarms",
                  .text = "Which swarm."});
  rows.push_back({.path = at + ".reached.goal",
                  .type = KeyType::kName,
                  .fallback_text = "each swarm's own",
                  .text = "Which goal."});
  rows.push_back({.path = at + ".reached.fraction",
                  .type = KeyType::kComparison,
                  .min = 0.0,
                  .max = 1.0,
                  .required = true,
                  .text = "The share of agents, from 0 to 1."});
  const auto quantity = [&](const std::string& name, const std::string& unit, double max,
                            const std::string& text) {
    rows.push_back({.path = at + "." + name,
                    .type = KeyType::kComparison,
                    .unit = unit,
                    .min = 0.0,
                    .max = max,
                    .group = "quantity",
                    .text = text});
  };
  quantity("min_separation", "m", 1e6, "The smallest distance of two agents' centres at any tick.");
  quantity("penetrations", "", 1e15, "Agent-ticks with a centre inside an obstacle.");
  quantity("collisions", "", 1e15, "Encounters nearer than the two radii together, each counted once.");
  quantity("mde_percent", "%", 100.0, "The share of agents that minimum-distance enforcement moves a tick.");
  quantity("max_speed", "m/s", 1e6, "The largest speed of any agent at any tick.");
  quantity("max_acceleration", "m/s²", 1e9, "The largest change of velocity of any agent, by time.");
  quantity("governor_interventions", "", 1e15, "Commands that the governor changed.");
  quantity("missed", "", 1e15, "Control ticks that ended after their deadline.");
  quantity("faults", "", 1e15, "HAL faults.");
}

}  // namespace

std::vector<Key> schema_rows() {
  Rows rows;
  add_top_rows(rows);
  add_world_rows(rows);
  add_swarm_rows(rows);
  add_run_rows(rows);
  add_hal_rows(rows);
  add_expect_rows(rows);
  return rows;
}

}  // namespace mayfly
