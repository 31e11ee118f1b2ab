// The rows of what a run is held to.
#include <string>

#include "controller/faults/fault_table.hpp"
#include "controller/safety/reaction_table.hpp"
#include "controller/scenario/schema_rows.hpp"

namespace mayfly {
namespace {

using Rows = std::vector<Key>;

// A quantity of one swarm: a map with the swarm, what else it needs, and the comparison.
void add_swarm_quantity(Rows& rows, const std::string& path, const std::string& text) {
  rows.push_back({.path = path, .type = KeyType::kMap, .group = "quantity", .text = text});
  rows.push_back({.path = path + ".swarm",
                  .type = KeyType::kName,
                  .fallback_text = "the swarm, where there is only one",
                  .text = "Which swarm."});
}

// "report" to "cut"
std::vector<std::string> severity_names() {
  std::vector<std::string> names;
  for (std::size_t s = 1; s < kSeverities; ++s) {
    names.emplace_back(key_of(static_cast<Severity>(s)));
  }
  return names;
}

void add_measure(Rows& rows, const std::string& path, const std::string& unit, const std::string& text,
                 double max = 1e9) {
  rows.push_back({.path = path,
                  .type = KeyType::kComparison,
                  .unit = unit,
                  .min = 0.0,
                  .max = max,
                  .required = true,
                  .text = text});
}

// A quantity of one swarm and one stimulus.
void add_stimulus_quantity(Rows& rows, const std::string& path, const std::string& text) {
  add_swarm_quantity(rows, path, text);
  rows.push_back({.path = path + ".stimulus",
                  .type = KeyType::kName,
                  .required = true,
                  .text = "Which lamp, predator, food or mate."});
}

// How a swarm moves as a whole.
void add_motion_rows(Rows& rows, const std::string& at) {
  add_swarm_quantity(rows, at + ".drift", "How far the swarm's centre was from where it started, at most.");
  add_measure(rows, at + ".drift.distance", "m", "The largest distance.");
  add_swarm_quantity(rows, at + ".goal_distance",
                     "How far the agents are from the goal's centre, which may move.");
  rows.push_back({.path = at + ".goal_distance.goal",
                  .type = KeyType::kName,
                  .fallback_text = "the swarm's own",
                  .text = "Which goal."});
  add_measure(rows, at + ".goal_distance.distance", "m",
              "The mean over the agents and the run's second half.");
  add_swarm_quantity(
      rows, at + ".turns",
      "How often an agent circles a vertical axis; a turn one way takes back one the other way.");
  rows.push_back({.path = at + ".turns.around",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .group = "axis",
                  .text = "A point of the axis."});
  rows.push_back({.path = at + ".turns.lamp",
                  .type = KeyType::kName,
                  .group = "axis",
                  .text = "The lamp through which the axis goes."});
  add_measure(rows, at + ".turns.number", "", "The mean over the agents, in whole turns.");
  add_swarm_quantity(rows, at + ".spread", "How far the swarm is spread about its centre.");
  add_measure(rows, at + ".spread.radius", "m",
              "The radius of gyration (root mean square distance), mean of the run's last tenth.");
}

// What swarms of insects are known by.
void add_order_rows(Rows& rows, const std::string& at) {
  add_swarm_quantity(rows, at + ".polarisation", "Whether all fly the same way.");
  add_measure(rows, at + ".polarisation.order", "",
              "The length of the mean of the agents' directions, mean of the run's second half: 1 where all "
              "fly the same way.",
              1.0);
  add_swarm_quantity(rows, at + ".milling", "Whether all circle their centre the same way round.");
  add_measure(rows, at + ".milling.order", "",
              "The mean over agents of the sine between their way from the centre and their velocity, both "
              "seen from above, without its sign; mean of the run's second half: 1 where all circle.",
              1.0);
  add_swarm_quantity(rows, at + ".nearest_neighbour", "How far an agent is from the nearest of its swarm.");
  add_measure(rows, at + ".nearest_neighbour.distance", "m",
              "The mean over the agents and the run's second half.");
}

// What swarms do about what they feel.
void add_answer_rows(Rows& rows, const std::string& at) {
  add_stimulus_quantity(rows, at + ".stimulus_distance", "How far the agents are from a stimulus.");
  add_measure(rows, at + ".stimulus_distance.distance", "m",
              "The mean over the agents and the run's second half.");
  add_stimulus_quantity(rows, at + ".arrived", "How many agents are near a stimulus.");
  rows.push_back({.path = at + ".arrived.within",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = kFarthest,
                  .above_min = true,
                  .required = true,
                  .text = "How near that is."});
  rows.push_back({.path = at + ".arrived.at",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1e6,
                  .fallback_text = "at the run's end",
                  .text = "When."});
  add_measure(rows, at + ".arrived.fraction", "",
              "The share of the swarm's agents, those counted that have not joined yet, from 0 to 1.", 1.0);
  add_stimulus_quantity(rows, at + ".clearing", "How near any agent came to a stimulus.");
  add_measure(rows, at + ".clearing.distance", "m", "The least distance at any tick.");
  add_stimulus_quantity(rows, at + ".parting",
                        "How far the swarm is driven apart, from the tick at which a stimulus first has an "
                        "agent in its reach.");
  add_measure(rows, at + ".parting.ratio", "", "The largest radius of gyration by that of this tick.");
  add_stimulus_quantity(rows, at + ".closing", "Whether the swarm has come together again after that.");
  add_measure(rows, at + ".closing.ratio", "",
              "The radius of gyration of the run's last tenth by that of the same tick.");
}

// What the guard makes of the faults that a scenario injects.
void add_fault_answer_rows(Rows& rows, const std::string& at) {
  rows.push_back({.path = at + ".noticed",
                  .type = KeyType::kMap,
                  .group = "quantity",
                  .text = "How soon a fault that the scenario injects is reported by its symptom."});
  rows.push_back({.path = at + ".noticed.fault",
                  .type = KeyType::kChoice,
                  .required = true,
                  .choices = fault_names(),
                  .text = "Which of `faults`."});
  add_measure(rows, at + ".noticed.within", "s",
              "The longest from the begin of such a fault to the first report of one whom it strikes.", 1e6);
  rows.push_back({.path = at + ".reacted",
                  .type = KeyType::kMap,
                  .group = "quantity",
                  .text = "How soon the guard does something about a fault that the scenario injects."});
  rows.push_back({.path = at + ".reacted.fault",
                  .type = KeyType::kChoice,
                  .required = true,
                  .choices = fault_names(),
                  .text = "Which of `faults`."});
  rows.push_back({.path = at + ".reacted.at_least",
                  .type = KeyType::kChoice,
                  .required = true,
                  .choices = severity_names(),
                  .text = "What it has to do, or more ([severities](../explanation/guard.md))."});
  add_measure(rows, at + ".reacted.within", "s",
              "The longest from the begin of such a fault to the first such reaction that is for one whom it "
              "strikes, or for everybody.",
              1e6);
}

}  // namespace

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
  quantity("field_age", "s", 1e6,
           "The age of the oldest field that was flown by, of those solved in flight.");
  quantity("wall_clearance", "m", 1e6, "The least distance of an agent's centre to an obstacle.");
  add_motion_rows(rows, at);
  add_order_rows(rows, at);
  add_answer_rows(rows, at);
  add_fault_answer_rows(rows, at);
  quantity("safety_breaches", "", 1e15,
           "Breaches of what the guard promises, by the robots' true places at every plant step and by what "
           "they were told: bodies that touch, bodies outside the fence, commands beyond speed or "
           "acceleration. All robots of one HAL only.");
  quantity("infeasible", "", 1.0,
           "The share of agent-ticks, of swarms that avoid collisions, without a velocity clear of "
           "everybody.");
}

}  // namespace mayfly
