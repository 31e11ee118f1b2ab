// From a checked tree to a Scenario, one part of the file each. What a single key cannot show to be wrong (an
// empty box, a goal that no one defines, too many agents for their box) is found here, and collected.
#pragma once

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
    errors.push_back({.message = std::move(message),
                      .place = mark.place(),
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

WorldSpec build_world(const Values& world, const FileRoots& roots, Findings& findings);

std::vector<HalSpec> build_hals(const Values& top, float control_rate, Findings& findings);

// Needs the world and the HALs of `scenario`.
std::vector<SwarmSpec> build_swarms(const Values& top, const Scenario& scenario, const FileRoots& roots,
                                    Findings& findings);

// Needs the world and the swarms of `scenario`.
std::vector<Expectation> build_expectations(const Values& top, const Scenario& scenario, Findings& findings);

std::vector<PlannerSpec> build_planners(const Values& top, Findings& findings);

}  // namespace mayfly
