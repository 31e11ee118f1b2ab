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

void add_run_rows(Rows& rows) {
  rows.push_back(
      {.path = "planners", .type = KeyType::kMap, .text = "What plans beside control, at rates of its own."});
  for (const std::string name : {"curl_noise", "pso"}) {
    rows.push_back(
        {.path = "planners." + name,
         .type = KeyType::kMap,
         .text =
             name == "pso"
                 ? "The particle-swarm planner; accepted, not flown in this version."
                 : "The model of every swarm, noise included, beside control: it flies the last velocities "
                   "that were planned. Without it, the model runs in every control tick."});
    rows.push_back({.path = "planners." + name + ".rate",
                    .type = KeyType::kNumber,
                    .unit = "Hz",
                    .min = 0.01,
                    .max = 1e4,
                    .required = true,
                    .text = "How often it plans."});
  }
  rows.push_back({.path = "planners.curl_noise.latency",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 100.0,
                  .fallback_text = "one period of the planner",
                  .text = "From when a plan is begun to when it is flown; at most one period."});
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
  rows.push_back({.path = "control.realtime",
                  .type = KeyType::kChoice,
                  .fallback = "ignore",
                  .choices = {"ignore", "enforce"},
                  .text =
                      "On the real clock, where the system refuses priority or locked memory: fly without "
                      "and say so, or refuse to fly."});
  rows.push_back({.path = "control.guard",
                  .type = KeyType::kChoice,
                  .fallback = "inline",
                  .choices = {"inline", "process"},
                  .text =
                      "Where the guard runs: with the planner, or in a process of its own, which brings the "
                      "robots to rest whatever becomes of the planner. `--guard` overrides it."});
  rows.push_back({.path = "record", .type = KeyType::kMap, .text = "The recording."});
  rows.push_back({.path = "record.rate",
                  .type = KeyType::kNumber,
                  .unit = "Hz",
                  .min = 0.01,
                  .max = 1e4,
                  .fallback = "20",
                  .text = "Samples a second; at most the control rate."});
}

// How the poses of a HAL's robots are measured.
void add_sensing_rows(Rows& rows, const std::string& at) {
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
  add_sensing_rows(rows, at);
  rows.push_back({.path = at + ".endurance",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 1.0,
                  .max = 1e6,
                  .fallback_text = "for ever",
                  .text = "How long a full battery lasts."});
  rows.push_back({.path = at + ".links",
                  .type = KeyType::kInteger,
                  .min = 1,
                  .max = 64,
                  .fallback = "1",
                  .text = "Radio links that its robots are dealt to in equal parts, as to so many dongles."});
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
  add_fault_rows(rows);
  add_twin_rows(rows);
  add_expect_rows(rows);
  return rows;
}

}  // namespace mayfly
