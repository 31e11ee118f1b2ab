#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/scenario/build.hpp"
#include "controller/scenario/names.hpp"
#include "controller/scenario/packing.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

constexpr float kMostLatencyTicks = 8.0F;  // as the governor's
constexpr long long kMaxAgents = 2'000'000;

NoiseSpec build_noise(const Values& noise, Findings& findings) {
  NoiseSpec spec;
  spec.kind = std::array{NoiseKind::kCurl, NoiseKind::kNone, NoiseKind::kPerlin, NoiseKind::kWhite,
                         NoiseKind::kGaussian}[static_cast<std::size_t>(noise.choice("kind"))];
  spec.drift = noise.number_f("drift");
  if (spec.drift > 0.0F && (spec.kind == NoiseKind::kWhite || spec.kind == NoiseKind::kGaussian)) {
    findings.warn(noise.mark("drift"), "this noise is new at every tick: it has nothing that could drift");
  }
  spec.hash = noise.choice("hash") == 0 ? NoiseHash::kInteger : NoiseHash::kPerlin2002;
  const YamlNode* octaves = noise.node("octaves");
  if (octaves == nullptr) {
    spec.octaves = {{noise.number_f("scale"), noise.number_f("gain")}};
    return spec;
  }
  if (noise.has("scale") || noise.has("gain")) {
    findings.error(octaves->mark, "'octaves' and 'scale' with 'gain' both say what the noise is", "",
                   "one of the two");
  }
  spec.octaves.clear();
  for (const YamlNode& item : octaves->items) {
    const Values octave = noise.element("octaves", item);
    spec.octaves.push_back({octave.number_f("scale"), octave.number_f("gain")});
  }
  return spec;
}

CostSpec build_cost(const Values& cost, float cell) {
  const bool is_eq7 = cost.choice("preset") == 1;
  CostSpec spec;
  spec.length_weight = cost.maybe_number("length_weight").value_or(is_eq7 ? cell : 0.6F);  // Wang14 Eq. 7, 4
  spec.repulsion_weight =
      cost.maybe_number("repulsion_weight").value_or(is_eq7 ? 4.0F : 0.4F);  // Wang14 Eq. 7, 4
  spec.influence = cost.maybe_number("influence");
  spec.density_weight = cost.number_f("density_weight");
  return spec;
}

LimitsSpec build_limits(const Values& limits, float radius) {
  constexpr float kLeastSeparation = 0.2F;  // m
  LimitsSpec spec;
  spec.speed = limits.number_f("speed");
  spec.acceleration = limits.number_f("acceleration");
  spec.braking = limits.maybe_number("braking").value_or(spec.acceleration);
  spec.tube = limits.number_f("tube");
  spec.latency = limits.number_f("latency");
  spec.watchdog = limits.number_f("watchdog");
  spec.downwash = limits.number_f("downwash");
  spec.separation =
      limits.maybe_number("separation").value_or(std::max(kLeastSeparation, 2.0F * (radius + spec.tube)));
  return spec;
}

// Of the region made `factor` times as long each way.
double grown_volume(const fields::Shape& start, double separation, double factor = 1.0) {
  if (const auto* sphere = std::get_if<fields::SphereShape>(&start)) {
    return grown_sphere_volume(factor * sphere->radius, separation);
  }
  const glm::dvec3 size = factor * (glm::dvec3(box_around(start)->max) - glm::dvec3(box_around(start)->min));
  return grown_box_volume(size.x, size.y, size.z, separation);
}

double factor_that_fits(const SwarmSpec& swarm) {
  const double separation = swarm.limits.separation;
  double factor = 1.0;
  while (packed_share(swarm.count, separation, grown_volume(swarm.start, separation, factor)) >
         kRandomClosePacking) {
    factor = std::ceil(101.0 * factor) / 100.0;
  }
  return factor;
}

void check_room(const SwarmSpec& swarm, const YamlMark& mark, Findings& findings) {
  const double separation = swarm.limits.separation;
  if (separation <= 0.0 || swarm.count <= 1) {
    return;
  }
  const double volume = grown_volume(swarm.start, separation);
  const double share = packed_share(swarm.count, separation, volume);
  if (share > kRandomClosePacking) {
    findings.error(
        mark, fmt::format("swarm '{}' does not fit its start region", swarm.name),
        fmt::format("{} agents {:g} m apart, which would fill {:.0f} % of it", swarm.count, separation,
                    100.0 * share),
        fmt::format("at most {:.0f} agents, or a region {:.8g} times as long each way",
                    count_that_fits(separation, volume, kRandomClosePacking), factor_that_fits(swarm)));
  } else if (share > kRandomAddition) {
    findings.warn(
        mark, fmt::format("swarm '{}' fills {:.0f} % of its start region, so that places are hard to find; "
                          "at most {:.0f} agents start with ease",
                          swarm.name, 100.0 * share, count_that_fits(separation, volume, kRandomAddition)));
  }
}

void check_start(const Values& values, const SwarmSpec& swarm, const Box& bounds, Findings& findings) {
  const Box start = *box_around(swarm.start);
  if (!bounds.contains(start.min) || !bounds.contains(start.max)) {
    findings.error(values.mark("start"), fmt::format("swarm '{}' starts outside world.bounds", swarm.name),
                   "", "a start region that lies inside");
  }
  check_room(swarm, values.mark("start"), findings);
}

void check_speeds(const Values& values, const SwarmSpec& swarm, Findings& findings) {
  if (swarm.is_guided() && swarm.cruise_speed > swarm.limits.speed) {
    const bool own = values.has("cruise_speed");
    findings.error(
        own ? values.mark("cruise_speed") : values.map("limits").mark("speed"),
        "the cruise speed is above the speed limit",
        fmt::format("cruise_speed {:g} and limits.speed {:g}", swarm.cruise_speed, swarm.limits.speed),
        "a cruise speed of at most the limit");
  }
  if (swarm.limits.separation < 2.0F * swarm.radius && !swarm.governor) {
    findings.warn(
        values.has("limits") ? values.map("limits").mark("separation") : values.mark("name"),
        fmt::format(
            "swarm '{}': a separation of {:g} m is less than two radii ({:g} m), so that bodies may touch",
            swarm.name, swarm.limits.separation, 2.0F * swarm.radius));
  }
}

// What the governor would refuse, where the file says it.
void check_governed(const Values& values, const SwarmSpec& swarm, float rate, Findings& findings) {
  const LimitsSpec& limits = swarm.limits;
  if (limits.braking > limits.acceleration) {
    findings.error(values.map("limits").mark("braking"), "nobody brakes harder than it accelerates",
                   fmt::format("braking {:g} m/s²", limits.braking),
                   fmt::format("<= acceleration = {:g} m/s²", limits.acceleration));
  }
  if (!swarm.governor) {
    return;
  }
  if (limits.latency * rate > kMostLatencyTicks) {
    findings.error(values.map("limits").mark("latency"), "the latency is too long to be governed",
                   fmt::format("{:g} s, {:g} control periods", limits.latency, limits.latency * rate),
                   fmt::format("at most {:g} control periods", kMostLatencyTicks));
  }
  const float least = 2.0F * (swarm.radius + limits.tube);
  if (limits.separation > 0.0F && limits.separation < least * (1.0F - 1e-6F)) {
    findings.error(
        values.map("limits").mark("separation"), "the separation is below what the governor keeps",
        fmt::format("{:g} m", limits.separation),
        fmt::format(">= 2 · (radius {:g} + tube {:g}) = {:g} m", swarm.radius, limits.tube, least));
  } else if (limits.separation > 0.0F && limits.speed * limits.watchdog > limits.separation) {
    findings.error(values.map("limits").mark("watchdog"),
                   "a robot that hears nothing flies on for more than the separation",
                   fmt::format("speed {:g} · watchdog {:g} = {:g} m", limits.speed, limits.watchdog,
                               limits.speed * limits.watchdog),
                   fmt::format("<= separation = {:g} m", limits.separation));
  }
}

// So many standard deviations of the noise are a tube that is hardly ever left.
constexpr float kNoiseTubes = 5.0F;

void check_tube(const Values& values, const SwarmSpec& swarm, const std::vector<HalSpec>& hals,
                Findings& findings) {
  const auto hal =
      std::find_if(hals.begin(), hals.end(), [&](const HalSpec& spec) { return spec.name == swarm.robots; });
  if (!swarm.governor || hal == hals.end()) {
    return;
  }
  const float wanted = kNoiseTubes * hal->sim.pose_noise;
  if (swarm.limits.tube < wanted * (1.0F - 1e-6F)) {
    findings.warn(
        values.has("limits") ? values.map("limits").mark("tube") : values.mark("name"),
        fmt::format(
            "swarm '{}': limits.tube is {:g} m, but poses are noisy by {:g} m: {}; wanted >= "
            "{:g} · pose_noise = {:g} m",
            swarm.name, swarm.limits.tube, hal->sim.pose_noise,
            swarm.limits.tube > 0.0F ? "they leave it by chance" : "nothing is promised of the difference",
            kNoiseTubes, wanted));
  }
}

std::string build_robots(const Values& values, const std::vector<std::string>& hals, Findings& findings) {
  if (values.has("robots")) {
    find_named(values, "robots", hals, "HAL", findings);
    return values.text("robots");
  }
  if (hals.size() != 1) {
    findings.error(values.mark("robots"), "this swarm does not say whose robots it flies", "",
                   "'robots: ' and one of " + list_names(hals));
  }
  return hals.front();
}

// The border of the goal keeps a roaming swarm in, and only of boxes and spheres is it known exactly
// everywhere.
void check_roaming(const Values& values, const SwarmSpec& swarm, const std::vector<GoalSpec>& goals,
                   Findings& findings) {
  const auto goal =
      std::find_if(goals.begin(), goals.end(), [&](const GoalSpec& spec) { return spec.name == swarm.goal; });
  if (swarm.at_goal == AtGoal::kRoam && goal != goals.end() &&
      std::holds_alternative<fields::MeshShape>(goal->shape)) {
    findings.error(values.mark("at_goal"), fmt::format("nobody can roam in goal '{}'", goal->name), "a mesh",
                   "a goal that is a box or a sphere");
  }
}

void build_goal(const Values& values, const Scenario& scenario, SwarmSpec& swarm, Findings& findings) {
  if (values.has("goal")) {
    swarm.goal_index = find_named(values, "goal", names_of(scenario.world.goals), "goal", findings);
  } else if (swarm.is_guided()) {
    findings.error(values.mark("goal"), "the key 'goal' is missing in swarms[]", "",
                   "a name of world.goals: this model is led to its goal");
  }
}

SwarmSpec build_swarm(const Values& values, const Scenario& scenario, const FileRoots& roots,
                      Findings& findings) {
  SwarmSpec swarm;
  swarm.name = values.text("name");
  swarm.count = static_cast<int>(values.integer("count"));
  const std::size_t before = findings.errors.size();
  swarm.start = build_shape(values.map("start"), roots, findings);
  const bool has_start = findings.errors.size() == before;
  swarm.goal = values.text("goal");
  swarm.at_goal = values.choice("at_goal") == 0 ? AtGoal::kRest : AtGoal::kRoam;
  swarm.noise = build_noise(values.map("noise"), findings);
  swarm.cost = build_cost(values.map("cost"), scenario.world.cell);
  swarm.cruise_speed = values.number_f("cruise_speed");
  swarm.boundary = values.maybe_number("boundary");
  swarm.radius = values.number_f("radius");
  swarm.limits = build_limits(values.map("limits"), swarm.radius);
  swarm.mde_sweeps = static_cast<int>(values.integer("mde_sweeps"));
  swarm.governor = values.flag("governor");
  swarm.robots = build_robots(values, names_of(scenario.hals), findings);
  check_tube(values, swarm, scenario.hals, findings);
  swarm.start_place = values.mark("start").place();
  swarm.goal_place = values.mark("goal").place();
  build_models(values, swarm, findings);
  build_roster(values, swarm, findings);
  build_goal(values, scenario, swarm, findings);
  check_roaming(values, swarm, scenario.world.goals, findings);
  check_speeds(values, swarm, findings);
  check_governed(values, swarm, scenario.control.rate, findings);
  const Box& bounds = scenario.world.bounds;
  if (has_start && bounds.min.x < bounds.max.x && bounds.min.y < bounds.max.y &&
      bounds.min.z < bounds.max.z) {
    check_start(values, swarm, bounds, findings);
  }
  return swarm;
}

}  // namespace

std::vector<SwarmSpec> build_swarms(const Values& top, const Scenario& scenario, const FileRoots& roots,
                                    Findings& findings) {
  std::vector<SwarmSpec> swarms;
  UniqueNames names("swarm");
  long long agents = 0;
  for (const YamlNode& item : top.node("swarms")->items) {
    const Values values = top.element("swarms", item);
    swarms.push_back(build_swarm(values, scenario, roots, findings));
    SwarmSpec& swarm = swarms.back();
    swarm.place = item.mark.place();
    names.add(values, findings);
    const bool was_over = agents > kMaxAgents;
    agents += swarm.count;
    if (agents > kMaxAgents && !was_over) {
      findings.error(values.mark("count"), "the swarms have too many agents together",
                     fmt::format("{} up to this one", agents), fmt::format("at most {}", kMaxAgents));
    }
  }
  return swarms;
}

}  // namespace mayfly
