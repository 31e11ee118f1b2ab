// What goes wrong, to whom and when.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "controller/scenario/names.hpp"
#include "controller/scenario/numbers.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

constexpr std::array kSizes{FaultSize::kShare, FaultSize::kDistance, FaultSize::kSpeed, FaultSize::kTime};

// Chances that follow from the seed and from which draw it is (SplitMix64, Steele et al. 2014).
class Chances {
 public:
  explicit Chances(std::uint64_t seed) : state_(seed) {}

  double unit() {  // in [0, 1)
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(unit() * static_cast<double>(count)));
  }
  glm::vec3 level_direction() {
    const double angle = 2.0 * std::numbers::pi * unit();
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0F};
  }

 private:
  std::uint64_t state_;
};

std::size_t agents_of(const Scenario& scenario) {
  std::size_t agents = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    agents += static_cast<std::size_t>(swarm.count);
  }
  return agents;
}

bool has_direction(FaultKind kind) {
  return kind == FaultKind::kWind || kind == FaultKind::kPoseJump || kind == FaultKind::kPoseGhost ||
         kind == FaultKind::kStartTooNear || kind == FaultKind::kStartOutside;
}

void build_robots(FaultSpec& fault, const FaultRow& row, const Values& values, const Scenario& scenario,
                  Findings& findings) {
  const std::vector<Values::Name> names = values.names("robots");
  if (row.target == FaultTarget::kEverybody && !names.empty()) {
    findings.error(values.mark("robots"), fmt::format("'{}' strikes everybody", row.name), "",
                   "no 'robots' beside it");
  }
  std::size_t count = 0;
  bool all_known = true;
  for (const Values::Name& name : names) {
    const auto range = find_robots(name, scenario, findings);
    all_known = all_known && range.has_value();
    count += range ? range->count : 0;
    fault.agents.push_back(range.value_or(StruckAgents{}));
  }
  if (names.empty()) {
    fault.agents.push_back({0, agents_of(scenario)});
    count = agents_of(scenario);
  }
  if (row.target == FaultTarget::kPair && all_known && count != 2) {
    findings.error(values.mark("robots"), fmt::format("'{}' strikes two robots", row.name),
                   fmt::format("{}", count), "a list of two, such as [flies_0, flies_1]");
  }
}

void build_size(FaultSpec& fault, const FaultRow& row, const Values& values, Findings& findings) {
  fault.size = row.usual_size;
  for (const FaultSize size : kSizes) {
    const std::string key(key_of(size));
    if (!values.has(key)) {
      continue;
    }
    if (size == row.size) {
      fault.size = values.number(key);
      continue;
    }
    const std::string own(key_of(row.size));
    findings.error(values.mark(key), fmt::format("'{}' means nothing for '{}'", key, row.name), "",
                   own.empty() ? "no size" : "'" + own + "'", own);
  }
}

void build_direction(FaultSpec& fault, const FaultRow& row, const Values& values, Findings& findings) {
  if (!values.has("direction")) {
    return;
  }
  const glm::vec3 direction = values.vector("direction");
  const float length = glm::length(direction);
  if (!has_direction(row.kind)) {
    findings.error(values.mark("direction"), fmt::format("'{}' has no direction", row.name));
  } else if (!(length > 0.0F)) {
    findings.error(values.mark("direction"), "this leads nowhere", "[0, 0, 0]",
                   "a vector of any length but 0");
  } else {
    fault.direction = direction / length;
  }
}

void check_time(const FaultSpec& fault, const FaultRow& row, const Values& values, const Scenario& scenario,
                Findings& findings) {
  if (row.place == FaultPlace::kStart && fault.at > 0.0) {
    findings.error(values.mark("at"), fmt::format("'{}' is how a flight starts", row.name),
                   fmt::format("{:g} s", fault.at), "no 'at', or 0");
  } else if (fault.at >= scenario.duration) {
    findings.warn(values.mark("at"), fmt::format("'{}' begins at {:g} s, when the run of {:g} s is over",
                                                 row.name, fault.at, scenario.duration));
  }
}

FaultSpec build_fault(const Values& values, const Scenario& scenario, Chances chances, Findings& findings) {
  const FaultRow& row = fault_rows()[static_cast<std::size_t>(values.choice("what"))];
  FaultSpec fault;
  fault.kind = row.kind;
  fault.at = values.number("at");
  fault.length = values.has("for") ? values.number("for") : fault.length;
  fault.direction = chances.level_direction();
  build_robots(fault, row, values, scenario, findings);
  build_size(fault, row, values, findings);
  build_direction(fault, row, values, findings);
  check_time(fault, row, values, scenario, findings);
  return fault;
}

std::vector<FaultKind> random_kinds(const Values& values, Findings& findings) {
  std::vector<FaultKind> kinds;
  for (const Values::Name& name : values.names("what")) {
    const FaultRow* row = find_fault(name.text);
    if (row == nullptr) {
      findings.error(name.mark, fmt::format("there is no fault '{}'", name.text), "",
                     "one of " + list_names(fault_names()), nearest_name(name.text, fault_names()));
    } else {
      kinds.push_back(row->kind);
    }
  }
  for (const FaultRow& row : fault_rows()) {
    if (!values.has("what") && row.place != FaultPlace::kStart && row.place != FaultPlace::kOperator) {
      kinds.push_back(row.kind);
    }
  }
  return kinds;
}

void pick_robots(FaultSpec& fault, FaultTarget target, std::size_t agents, Chances& chances) {
  if (target == FaultTarget::kEverybody) {
    fault.agents.push_back({0, agents});
    return;
  }
  const std::size_t one = chances.below(agents);
  fault.agents.push_back({one, 1});
  if (target == FaultTarget::kPair) {
    fault.agents.push_back({(one + 1 + chances.below(std::max<std::size_t>(1, agents - 1))) % agents, 1});
  }
}

void add_random(std::vector<FaultSpec>& faults, const Values& values, const Scenario& scenario,
                Chances chances, Findings& findings) {
  const std::vector<FaultKind> kinds = random_kinds(values, findings);
  const double longest = values.number("longest");
  for (long long i = 0; i < values.integer("count") && !kinds.empty(); ++i) {
    const FaultRow& row = fault_row(kinds[chances.below(kinds.size())]);
    FaultSpec fault;
    fault.kind = row.kind;
    fault.at = row.place == FaultPlace::kStart ? 0.0 : chances.unit() * scenario.duration;
    fault.length = std::max(1e-3, chances.unit()) * longest;
    fault.size = row.usual_size;
    fault.direction = chances.level_direction();
    pick_robots(fault, row.target, agents_of(scenario), chances);
    faults.push_back(std::move(fault));
  }
}

}  // namespace

std::optional<StruckAgents> find_robots(const Values::Name& name, const Scenario& scenario,
                                        Findings& findings) {
  if (name.text == "all") {
    return StruckAgents{0, agents_of(scenario)};
  }
  std::vector<std::string> names{"all"};
  std::size_t first = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    const auto count = static_cast<std::size_t>(swarm.count);
    if (name.text == swarm.name) {
      return StruckAgents{first, count};
    }
    const std::string robot = swarm.name + "_";
    const auto number =
        name.text.starts_with(robot) ? read_integer(name.text.substr(robot.size())) : std::nullopt;
    if (number && *number >= 0 && *number < swarm.count) {
      return StruckAgents{first + static_cast<std::size_t>(*number), 1};
    }
    if (number) {
      findings.error(name.mark, fmt::format("there is no robot '{}'", name.text), "",
                     fmt::format("one of {}0 to {}{}", robot, robot, swarm.count - 1));
      return std::nullopt;
    }
    names.push_back(swarm.name);
    names.push_back(robot + "0");
    first += count;
  }
  findings.error(name.mark, fmt::format("there is no swarm or robot '{}'", name.text), "",
                 "one of " + list_names(names), nearest_name(name.text, names));
  return std::nullopt;
}

std::vector<FaultSpec> build_faults(const Values& top, const Scenario& scenario, Findings& findings) {
  std::vector<FaultSpec> faults;
  const YamlNode* list = top.node("faults");
  if (list == nullptr || agents_of(scenario) == 0) {
    return faults;
  }
  Chances seeds(scenario.seed ^ 0xFA017U);
  for (const YamlNode& item : list->items) {
    const Values values = top.element("faults", item);
    const Chances chances(static_cast<std::uint64_t>(seeds.unit() * 0x1p53));
    if (values.has("random")) {
      add_random(faults, values.map("random"), scenario, chances, findings);
    } else {
      faults.push_back(build_fault(values, scenario, chances, findings));
    }
  }
  return faults;
}

}  // namespace mayfly
