#include "app/summary_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace mayfly::app {
namespace {

constexpr std::size_t kMostFaults = 5;

using Out = std::back_insert_iterator<std::string>;

template <class Number>
std::string or_dash(const char* format, const std::optional<Number>& value) {
  return value ? fmt::format(fmt::runtime(format), *value) : "not measured";
}

void line(Out out, std::string_view name, std::string_view text) {
  fmt::format_to(out, "  {:<16} {}\n", name, text);
}

void add_motion(Out out, const Summary& s) {
  if (s.reached_fraction) {
    line(out, "reached",
         fmt::format("{:.4g} % of the agents entered their goal", 100.0 * *s.reached_fraction));
  }
  line(out, "separation",
       fmt::format("{} at least, {} collisions", or_dash("{:.4g} m", s.min_separation_m),
                   or_dash("{}", s.collisions)));
  line(out, "obstacles", fmt::format("{} agent-ticks inside", or_dash("{}", s.penetrations)));
  if (s.mde_percent) {
    line(out, "moved by MDE", fmt::format("{:.3g} % of the agents a tick", *s.mde_percent));
  }
  if (s.infeasible_agents) {
    line(
        out, "avoidance",
        fmt::format("{} agent-ticks without a velocity clear of everybody{}", *s.infeasible_agents,
                    s.all_infeasible_s ? fmt::format("; every agent at {:.4g} s", *s.all_infeasible_s) : ""));
  }
  line(out, "at most",
       fmt::format("{}, {}", or_dash("{:.3g} m/s", s.max_speed_mps),
                   or_dash("{:.3g} m/s²", s.max_acceleration_mps2)));
  line(out, "governor", fmt::format("{} interventions (agent-ticks)", s.governor_interventions));
}

std::string text_of(const LatencySummary& latency) {
  return fmt::format("{:.0f} µs (median), 99 % below {:.0f} µs, 99.9 % below {:.0f} µs, {:.0f} µs at worst",
                     latency.p50, latency.p99, latency.p999, latency.max);
}

void add_tasks(Out out, const ControlSummary& control) {
  for (const TaskSummary& task : control.tasks) {
    if (task.thread == "own") {
      line(out, task.name,
           fmt::format("{} times at {:.4g} Hz, {} missed; {}", task.ticks, task.rate_hz, task.missed,
                       task.run_us ? "work " + text_of(*task.run_us) : "no work"));
    }
  }
  for (const AgeSummary& age : control.ages) {
    line(out, "age",
         fmt::format("{}: {}; {} times older than {:.3g} s", age.name,
                     age.age_s
                         ? fmt::format("{:.3g} s (median), {:.3g} s at worst", age.age_s->p50, age.age_s->max)
                         : "there never was one",
                     age.expired, age.limit_s));
  }
}

void add_punctuality(Out out, const ControlSummary& control) {
  if (control.jitter_us) {
    line(out, "jitter", text_of(*control.jitter_us));
    line(out, "missed",
         fmt::format("{} releases beside {} ticks flown, {} of them because the machine woke us late",
                     control.missed, control.ticks, control.missed_by_machine));
  }
  if (control.witness_us) {
    line(out, "witness", text_of(*control.witness_us) + " for a bare thread beside control");
  }
  line(out, "rights", control.realtime);
  for (const std::string& right : control.missing_rights) {
    line(out, "", "without " + right);
  }
}

void add_timing(Out out, const Summary& s, bool real_time) {
  const auto& p = s.preprocessing_s;
  line(out, "fields",
       fmt::format("distance {:.3f} s{}, cost {:.3f} s{}", p.distance, p.distance_cached ? " (cached)" : "",
                   p.cost, p.cost_cached ? " (cached)" : ""));
  if (s.fields && s.fields->age_s) {
    line(out, "in flight",
         fmt::format("fields solved {} times in {} (median), {:.3g} s old (median), {:.3g} s at worst",
                     s.fields->updates,
                     s.fields->solve_s ? fmt::format("{:.3g} ms", 1e3 * s.fields->solve_s->p50) : "no time",
                     s.fields->age_s->p50, s.fields->age_s->max));
  }
  if (s.control.run_us) {
    line(out, "work",
         fmt::format("{:.0f} µs a tick (median), 99 % below {:.0f} µs, {}", s.control.run_us->p50,
                     s.control.run_us->p99, or_dash("{:.0f} ns an agent", s.ns_per_agent_tick)));
  }
  add_tasks(out, s.control);
  if (real_time) {
    add_punctuality(out, s.control);
  }
}

void add_faults(Out out, const Summary& s) {
  if (s.faults.empty()) {
    line(out, "faults", "none");
    return;
  }
  line(out, "faults", fmt::format("{}", s.faults.size()));
  for (std::size_t i = 0; i < std::min(kMostFaults, s.faults.size()); ++i) {
    const FaultEvent& f = s.faults[i];
    line(out, "",
         fmt::format("{:.2f} s  {} on {}: {}", f.time_s, f.robot.empty() ? "all robots" : f.robot, f.link,
                     f.cause));
  }
  if (s.faults.size() > kMostFaults) {
    line(out, "", fmt::format("… and {} more, in the summary file", s.faults.size() - kMostFaults));
  }
}

void add_expectations(Out out, const Summary& s) {
  std::size_t width = 0;
  for (const ExpectationResult& result : s.expect) {
    width = std::max(width, result.name.size());
  }
  for (const ExpectationResult& result : s.expect) {
    fmt::format_to(out, "  {} {:<{}}  {}, wanted {}\n", result.pass ? "pass" : "FAIL", result.name, width,
                   or_dash("{:.6g}", result.value), result.wanted);
  }
}

}  // namespace

std::string summary_table(const Summary& s, bool real_time) {
  std::string text;
  const Out out(text);
  fmt::format_to(out, "{}: {} agent{}, {} engine, HAL {}, seed {}{}\n", s.scenario, s.agents,
                 s.agents == 1 ? "" : "s", s.engine, s.hal, s.seed,
                 s.stopped_by_user ? "; stopped by the user" : "");
  line(out, "flown",
       fmt::format("{:.4g} s in {:.3g} s ({:.3g} × real time), {} ticks at {:.4g} Hz", s.simulated_s,
                   s.wall_s, s.realtime_factor, s.ticks, s.control.rate_hz));
  add_motion(out, s);
  add_timing(out, s, real_time);
  add_faults(out, s);
  add_expectations(out, s);
  return text;
}

}  // namespace mayfly::app
