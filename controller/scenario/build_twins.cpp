// Who is taken out of the run, and when.
#include <fmt/format.h>

#include <algorithm>

#include "controller/scenario/build.hpp"

namespace mayfly {
namespace {

bool is_governed(std::size_t agent, const Scenario& scenario) {
  std::size_t end = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    end += static_cast<std::size_t>(swarm.count);
    if (agent < end) {
      return swarm.governor;
    }
  }
  return false;
}

void check_twin(const TwinSpec& twin, const Values& values, const std::vector<TwinSpec>& before,
                const Scenario& scenario, Findings& findings) {
  if (!is_governed(twin.agent, scenario)) {
    findings.error(values.mark("robot"), "nobody would keep clear of it", "a swarm with 'governor: off'",
                   "a robot under the governor");
  }
  if (twin.until <= twin.from) {
    findings.error(values.mark("until"), "it would be put back before it is taken out",
                   fmt::format("{:g} s", twin.until), fmt::format("after 'from', {:g} s", twin.from));
  }
  if (std::any_of(before.begin(), before.end(), [&](const TwinSpec& b) { return b.agent == twin.agent; })) {
    findings.error(values.mark("robot"), "this robot is taken out twice", "", "once a run");
  }
  if (twin.from >= scenario.duration) {
    findings.warn(values.mark("from"),
                  fmt::format("it is taken out at {:g} s, when the run of {:g} s is over", twin.from,
                              scenario.duration));
  }
}

}  // namespace

std::vector<TwinSpec> build_twins(const Values& top, const Scenario& scenario, Findings& findings) {
  std::vector<TwinSpec> twins;
  const YamlNode* list = top.node("twins");
  if (list == nullptr || scenario.swarms.empty()) {
    return twins;
  }
  for (const YamlNode& item : list->items) {
    const Values values = top.element("twins", item);
    TwinSpec twin;
    const auto robot = find_robots({values.text("robot"), values.mark("robot")}, scenario, findings);
    if (!robot) {
      continue;
    }
    twin.agent = robot->first;
    twin.from = values.number("from");
    twin.until = values.has("until") ? values.number("until") : twin.until;
    if (robot->count != 1) {
      findings.error(values.mark("robot"), "one robot is taken out at a time",
                     fmt::format("{} robots", robot->count), "one, such as 'flies_0'");
    }
    check_twin(twin, values, twins, scenario, findings);
    twins.push_back(twin);
  }
  return twins;
}

}  // namespace mayfly
