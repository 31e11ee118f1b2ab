// From a checked tree to a Scenario, one part of the file each. What a single key cannot show to be wrong (an
// empty box, a goal that no one defines, too many agents for their box) is found here, and collected.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "controller/scenario/files.hpp"
#include "controller/scenario/scenario.hpp"
#include "controller/scenario/values.hpp"

namespace mayfly {

// Where problems go while a scenario is built.
struct Findings {
  std::vector<Error> errors;
  std::vector<Error> warnings;

  void error(const YamlMark& mark, std::string message, std::string found = {}, std::string wanted = {},
             std::string suggestion = {}) {
    error(mark.place(), std::move(message), std::move(found), std::move(wanted), std::move(suggestion));
  }
  void error(Place place, std::string message, std::string found = {}, std::string wanted = {},
             std::string suggestion = {}) {
    errors.push_back({.message = std::move(message),
                      .place = std::move(place),
                      .found = std::move(found),
                      .wanted = std::move(wanted),
                      .suggestion = std::move(suggestion)});
  }
  void warn(const YamlMark& mark, std::string message) {
    warnings.push_back({.message = std::move(message), .place = mark.place()});
  }
};

// The one shape that `values` holds.
fields::Shape build_shape(const Values& values, const FileRoots& roots, Findings& findings);

// The box around a shape; empty for one that only its file knows, or that has no end.
std::optional<Box> box_around(const fields::Shape& shape);

// All but the brushes.
WorldSpec build_world(const Values& world, const FileRoots& roots, Findings& findings);

// How the shape beside it moves, and whether a goal stays inside the bounds on its way.
std::optional<PathSpec> build_path(const Values& shape, Findings& findings);
void check_goal_path(const Values& values, const GoalSpec& goal, const Box& bounds, Findings& findings);

// What moves the swarm of `values`, of which all but this is known: `swarm` is completed.
void build_models(const Values& values, SwarmSpec& swarm, Findings& findings);
// Who of it is there.
void build_roster(const Values& values, SwarmSpec& swarm, Findings& findings);

// These need the world and the swarms of `scenario`.
std::vector<BrushSpec> build_brushes(const Values& world, const Scenario& scenario, Findings& findings);
struct Stimuli {
  std::vector<LampSpec> lamps;
  std::vector<StimulusSpec> others;
};
Stimuli build_stimuli(const Values& top, const Scenario& scenario, Findings& findings);
// The name of the swarm that feels what `values` is; empty for all.
std::string swarm_of(const Values& values, const Scenario& scenario, Findings& findings);
void check_reaches(const YamlMark& mark, const char* what, glm::vec3 center, float reach, const Box& bounds,
                   Findings& findings);
// What only all brushes and lamps together show. Needs both in `scenario`.
void check_pulls(const Scenario& scenario, Findings& findings);

// Whether the fields of `scenario`, which is otherwise whole, fit into the memory that is there: `available`
// in bytes, empty where nobody knows.
void check_memory(const Values& world, const Scenario& scenario, std::optional<double> available,
                  Findings& findings);

std::vector<HalSpec> build_hals(const Values& top, float control_rate, Findings& findings);

// Needs the world and the HALs of `scenario`.
std::vector<SwarmSpec> build_swarms(const Values& top, const Scenario& scenario, const FileRoots& roots,
                                    Findings& findings);

// Needs the world, the swarms and the lamps of `scenario`.
std::vector<Expectation> build_expectations(const Values& top, const Scenario& scenario, Findings& findings);

// Needs the swarms, the HALs, the seed and the duration of `scenario`.
std::vector<FaultSpec> build_faults(const Values& top, const Scenario& scenario, Findings& findings);

// Of "flies", "flies_3" or "all"; nothing, and an error, where there is no such robot.
std::optional<StruckAgents> find_robots(const Values::Name& name, const Scenario& scenario,
                                        Findings& findings);

// Needs the swarms and the duration of `scenario`.
std::vector<TwinSpec> build_twins(const Values& top, const Scenario& scenario, Findings& findings);

std::vector<PlannerSpec> build_planners(const Values& top, Findings& findings);

}  // namespace mayfly
