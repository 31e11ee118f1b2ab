// A scenario as the program understands it: plain data, already checked, defaults filled in.
// scenario/load.hpp makes it from YAML; the keys are described once, in scenario/schema_rows.cpp, from which
// the checks, the JSON schema and the reference page come. SI units throughout; world frame x east, y north,
// z up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "controller/scenario/expectation.hpp"
#include "controller/scenario/fault_spec.hpp"
#include "controller/scenario/model_specs.hpp"
#include "controller/scenario/path_spec.hpp"
#include "controller/scenario/stimulus_specs.hpp"
#include "core/grid.hpp"
#include "core/result.hpp"
#include "fields/shape.hpp"

namespace mayfly {

struct ObstacleSpec {
  fields::Shape shape;
  Place place;  // where it stands in the file, for errors that only show when the fields are built
  std::optional<PathSpec> path{};  // of every shape but a half-space
};

struct GoalSpec {
  std::string name;
  fields::Shape shape;  // MeshShape, BoxShape or SphereShape
  Place place;
  std::optional<PathSpec> path{};
};

// What a user wants a swarm to be drawn to or kept from, beside the obstacles: full strength at the centre,
// nothing from `radius` on.
struct BrushSpec {
  enum class Effect { kAttract, kRepel };
  enum class Term {
    kCost,      // makes ways through it cheaper or dearer
    kPotential  // adds a velocity toward the centre or away from it
  };
  Effect effect = Effect::kAttract;
  Term term = Term::kCost;
  glm::vec3 center{0.0F};  // m
  float radius = 1.0F;     // m
  float strength = 1.0F;   // cost: 1/m, taken away or added at the centre; potential: m/s at its steepest
  std::string swarm;       // empty: all
  Place place;
};

struct PlaneSpec {                     // robots stay where normal · x <= offset
  glm::vec3 normal{0.0F, 0.0F, 1.0F};  // unit
  float offset = 0.0F;                 // m
};

struct WorldSpec {
  Box bounds;
  std::vector<PlaneSpec> fence;  // of the governor, besides the bounds
  float cell = 1.0F;             // m
  // m, a whole multiple of `cell`. Given: a nested grid, with cells of `cell` near obstacles and goals and of
  // this side elsewhere.
  std::optional<float> coarse_cell{};
  std::vector<ObstacleSpec> obstacles;
  std::vector<GoalSpec> goals;
  std::vector<BrushSpec> brushes;
};

enum class NoiseKind { kNone, kCurl, kPerlin, kWhite, kGaussian };
// What agents do in their goal: come to rest, each at a place of its own, or fly on there by noise alone.
enum class AtGoal { kRest, kRoam };
enum class NoiseHash { kInteger, kPerlin2002 };

struct NoiseSpec {
  NoiseKind kind = NoiseKind::kCurl;
  NoiseHash hash = NoiseHash::kInteger;
  // m/s. The sampling points of the three potentials drift along three different axes, so that the noise
  // changes its shape and its curl stays free of divergence; 0: the noise stands still.
  float drift = 0.0F;
  // Octaves: the potentials of one (scale, gain) pair each are added (Wang14 Eq. 1).
  struct Octave {
    float scale = 0.4F;  // m
    float gain = 0.25F;  // m²/s; of the force model, whose noise is a force, m²/s²
  };
  std::vector<Octave> octaves{Octave{}};
};

struct CostSpec {  // Wang14 Eq. 4: cost = length_weight · length + repulsion_weight · ∫g ds
  float length_weight = 0.6F;
  float repulsion_weight = 0.4F;
  std::optional<float> influence;  // m; default 2·√2·cell (Wang14 Eq. 6)
  float density_weight = 0.0F;     // m²: the cost of a metre for each agent in a m³, of all swarms; 0: off
};

struct LimitsSpec {
  float speed = 3.0F;          // m/s
  float acceleration = 20.0F;  // m/s²
  float separation = 0.2F;     // m, the minimum distance that MDE keeps
  float braking = 20.0F;       // m/s², at most the acceleration
  float tube = 0.0F;           // m, by which a robot may be off its reference
  float latency = 0.0F;        // s, the most
  float watchdog = 0.0F;       // s that a robot flies on unheard
  float downwash = 1.0F;
};

struct SwarmSpec {
  std::string name;
  int count = 0;
  fields::Shape start;  // BoxShape or SphereShape
  std::string goal;     // empty: it has none, which only models that need no guide allow
  AtGoal at_goal = AtGoal::kRest;
  Model model = Model::kField;
  ForcesSpec forces;
  BoidsSpec boids;
  BrownianSpec brownian;
  AvoidanceSpec avoidance;
  NoiseSpec noise;
  CostSpec cost;
  float cruise_speed = 1.5F;      // m/s, Wang14's s0
  std::optional<float> boundary;  // m, Wang14's d0; default one cell
  LimitsSpec limits;
  float radius = 0.05F;  // m, the body
  int mde_sweeps = 8;
  bool governor = true;
  std::optional<JoinSpec> join;  // empty: all are there from the start
  std::optional<LeaveSpec> leave;
  std::string robots;          // the name of a HAL below
  Place place;                 // of the swarm
  Place start_place;           // of its start
  Place goal_place;            // of its goal's name
  std::size_t goal_index = 0;  // of its goal in WorldSpec::goals, where it has one

  // Whether a cost field leads it to its goal.
  bool is_guided() const { return model == Model::kField || model == Model::kOrca; }
};

enum class PlantKind { kIdeal, kVelocityLag, kDoubleIntegrator };

struct SimHalSpec {
  PlantKind plant = PlantKind::kIdeal;
  float time_constant = 0.1F;  // s, velocity_lag
  float rate =
      200.0F;  // Hz, plant steps; at least the control rate, and a multiple of it on the virtual clock
  // Faults, all off by default.
  float pose_noise = 0.0F;  // m, standard deviation a coordinate
  float delay = 0.0F;       // s, between measuring and handing over
  float dropout = 0.0F;     // probability that one robot's sample of one tick is lost
  float freeze = 0.0F;  // probability a robot and second that its pose stays at its last value (stamps go on)
                        // for freeze_time
  float freeze_time = 0.5F;  // s
  float nan = 0.0F;          // probability that one sample is NaN
  float endurance = 0.0F;    // s that a full battery lasts; 0: for ever
  int links = 1;             // that its robots are dealt to in equal parts
};

struct HalSpec {
  std::string name;
  SimHalSpec sim;  // kind: sim is the only one so far
};

// Where the guard runs: with its planner, or in a process of its own (on the real clock).
enum class GuardPlace { kInline, kProcess };

// On the real clock, where the system refuses priority or locked memory.
enum class RealtimePolicy { kIgnore, kEnforce };

struct ControlSpec {
  float rate = 100.0F;  // Hz
  RealtimePolicy realtime = RealtimePolicy::kIgnore;
  GuardPlace guard = GuardPlace::kInline;
};

struct RecordSpec {
  float rate = 20.0F;  // Hz
};

// A robot that is taken out of the run: a simulated twin flies in its place, until it is put back.
struct TwinSpec {
  std::size_t agent = 0;                                   // in the scenario's order of agents
  double from = 0.0;                                       // s
  double until = std::numeric_limits<double>::infinity();  // s
};

// Of planners but `fields`. `pso` is read and kept, though nothing runs it yet (Scenario::warnings says so).
struct PlannerSpec {
  std::string name;
  float rate = 0.0F;               // Hz
  std::optional<float> latency{};  // s from a release to when its plan is flown; default one period
  Place place;
};

struct Scenario {
  std::filesystem::path file;
  std::string name;
  std::uint64_t seed = 1;
  double duration = 60.0;  // s
  WorldSpec world;
  std::vector<SwarmSpec> swarms;
  std::vector<LampSpec> lamps;
  std::vector<StimulusSpec> stimuli;
  // Hz, how often fields are solved again where goals or obstacles move or density counts.
  float field_rate = 5.0F;
  ControlSpec control;
  RecordSpec record;
  std::vector<HalSpec> hals;
  std::vector<FaultSpec> faults;
  std::vector<TwinSpec> twins;
  std::vector<Expectation> expect;
  std::vector<PlannerSpec> planners;
  std::vector<Error> warnings;  // what is odd but flies

  // Hz, how often the swarm's velocities are chosen anew: by the planner of the field model, or by control.
  float decision_rate() const {
    for (const PlannerSpec& planner : planners) {
      if (planner.name == "curl_noise") {
        return planner.rate;
      }
    }
    return control.rate;
  }
};

}  // namespace mayfly
