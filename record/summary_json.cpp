#include "record/summary_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace mayfly::record {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}
Json number(const std::optional<double>& value) {
  return value ? number(*value) : Json();
}
Json number(const std::optional<std::uint64_t>& value) {
  return value ? Json(*value) : Json();
}

Json latency(const std::optional<LatencySummary>& latency) {
  if (!latency) {
    return {{"p50", Json()}, {"p99", Json()}, {"p999", Json()}, {"max", Json()}};
  }
  return {{"p50", number(latency->p50)},
          {"p99", number(latency->p99)},
          {"p999", number(latency->p999)},
          {"max", number(latency->max)}};
}

Json spread(const std::optional<Spread>& spread) {
  if (!spread) {
    return {{"p50", Json()}, {"p99", Json()}, {"max", Json()}};
  }
  return {{"p50", number(spread->p50)}, {"p99", number(spread->p99)}, {"max", number(spread->max)}};
}

Json task(const TaskSummary& task) {
  return {{"name", task.name},
          {"thread", task.thread},
          {"rate_hz", number(task.rate_hz)},
          {"ticks", task.ticks},
          {"missed", task.missed},
          {"missed_by_machine", task.missed_by_machine},
          {"jitter_us", latency(task.jitter_us)},
          {"run_us", latency(task.run_us)}};
}

Json age(const AgeSummary& age) {
  return {{"name", age.name},
          {"limit_s", number(age.limit_s)},
          {"expired", age.expired},
          {"age_s", spread(age.age_s)}};
}

Json control(const ControlSummary& control) {
  auto tasks = Json::array();
  for (const TaskSummary& one : control.tasks) {
    tasks.push_back(task(one));
  }
  auto ages = Json::array();
  for (const AgeSummary& one : control.ages) {
    ages.push_back(age(one));
  }
  return {{"rate_hz", number(control.rate_hz)},
          {"ticks", control.ticks},
          {"missed", control.missed},
          {"missed_by_machine", control.missed_by_machine},
          {"jitter_us", latency(control.jitter_us)},
          {"run_us", latency(control.run_us)},
          {"realtime", control.realtime},
          {"missing_rights", control.missing_rights},
          {"witness_us", latency(control.witness_us)},
          {"tasks", tasks},
          {"ages", ages}};
}

Json fields(const std::optional<FieldsSummary>& fields) {
  return {{"updates", fields ? Json(fields->updates) : Json()},
          {"age_s", spread(fields ? fields->age_s : std::nullopt)},
          {"solve_s", spread(fields ? fields->solve_s : std::nullopt)},
          {"unreachable", fields ? Json(fields->unreachable) : Json()}};
}

Json faults(const std::vector<FaultEvent>& events) {
  auto list = Json::array();
  for (const FaultEvent& event : events) {
    list.push_back(Json{{"time_s", number(event.time_s)},
                        {"robot", event.robot},
                        {"link", event.link},
                        {"cause", event.cause},
                        {"severity", event.severity.empty() ? Json() : Json(event.severity)}});
  }
  return list;
}

Json counts(const std::vector<std::pair<std::string, std::uint64_t>>& named) {
  Json object = Json::object();
  for (const auto& [name, count] : named) {
    object[name] = count;
  }
  return object;
}

Json breaches(const std::optional<BreachSummary>& breaches) {
  if (!breaches) {
    return {};
  }
  return {{"separation", breaches->separation},
          {"fence", breaches->fence},
          {"speed", breaches->speed},
          {"acceleration", breaches->acceleration}};
}

Json safety(const SafetySummary& safety) {
  return {{"severity_max", safety.severity_max},   {"invariants", counts(safety.invariants)},
          {"reactions", counts(safety.reactions)}, {"wishes_refused", safety.wishes_refused},
          {"stalled_ticks", safety.stalled_ticks}, {"incidents", safety.incidents},
          {"breaches", breaches(safety.breaches)}};
}

Json expectations(const std::vector<ExpectationResult>& results) {
  auto list = Json::array();
  for (const ExpectationResult& result : results) {
    list.push_back(Json{{"name", result.name},
                        {"value", number(result.value)},
                        {"wanted", result.wanted},
                        {"pass", result.pass}});
  }
  return list;
}

}  // namespace

std::string to_json(const Summary& s) {
  const Json document{
      {"scenario", s.scenario},
      {"engine", s.engine},
      {"hal", s.hal},
      {"seed", s.seed},
      {"agents", s.agents},
      {"ticks", s.ticks},
      {"simulated_s", number(s.simulated_s)},
      {"wall_s", number(s.wall_s)},
      {"realtime_factor", number(s.realtime_factor)},
      {"ns_per_agent_tick", number(s.ns_per_agent_tick)},
      {"reached_fraction", number(s.reached_fraction)},
      {"min_separation_m", number(s.min_separation_m)},
      {"collisions", number(s.collisions)},
      {"penetrations", number(s.penetrations)},
      {"mde_percent", number(s.mde_percent)},
      {"infeasible_agents", number(s.infeasible_agents)},
      {"governor_interventions", s.governor_interventions},
      {"faults", faults(s.faults)},
      {"safety", safety(s.safety)},
      {"max_speed_mps", number(s.max_speed_mps)},
      {"max_acceleration_mps2", number(s.max_acceleration_mps2)},
      {"control", control(s.control)},
      {"preprocessing_s",
       {{"distance", number(s.preprocessing_s.distance)},
        {"noise", number(s.preprocessing_s.noise)},
        {"cost", number(s.preprocessing_s.cost)}}},
      {"fields", fields(s.fields)},
      {"expect", expectations(s.expect)},
  };
  // Names come from files: what is not UTF-8 in them is replaced rather than thrown about.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mayfly::record
