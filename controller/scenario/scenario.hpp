// A scenario as the program understands it: plain data, already checked, defaults filled in.
// scenario/load.hpp makes it from YAML; the keys are described once, in scenario/schema.cpp, from which the
// checks, the JSON schema and the reference page come. SI units throughout; world frame x east, y north, z
// up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "core/result.hpp"
#include "fields/shape.hpp"

namespace mayfly {

struct ObstacleSpec {
  fields::Shape shape;
  Place place;  // where it stands in the file, for errors that only show when the fields are built
};

struct GoalSpec {
  std::string name;
  fields::Shape shape;  // MeshShape, BoxShape or SphereShape
  Place place;
};

struct WorldSpec {
  Box bounds;
  float cell = 1.0F;  // m
  std::vector<ObstacleSpec> obstacles;
  std::vector<GoalSpec> goals;
};

enum class Model { kField };            // later: forces, shape, pso, boids, orca, brownian
enum class NoiseKind { kNone, kCurl };  // later: perlin, white, gaussian
enum class NoiseHash { kInteger, kPerlin2002 };

struct NoiseSpec {
  NoiseKind kind = NoiseKind::kCurl;
  NoiseHash hash = NoiseHash::kInteger;
  // Octaves: the potentials of one (scale, gain) pair each are added (Wang14 Eq. 1).
  struct Octave {
    float scale = 0.4F;  // m
    float gain = 0.25F;  // m²/s
  };
  std::vector<Octave> octaves{Octave{}};
};

struct CostSpec {  // Wang14 Eq. 4: cost = length_weight · length + repulsion_weight · ∫g ds
  float length_weight = 0.6F;
  float repulsion_weight = 0.4F;
  std::optional<float> influence;  // m; default 2·√2·cell (Wang14 Eq. 6)
};

struct LimitsSpec {
  float speed = 3.0F;          // m/s
  float acceleration = 20.0F;  // m/s²
  float separation = 0.2F;     // m, the minimum distance that MDE keeps
};

struct SwarmSpec {
  std::string name;
  int count = 0;
  fields::Shape start;  // BoxShape or SphereShape
  std::string goal;
  Model model = Model::kField;
  NoiseSpec noise;
  CostSpec cost;
  float cruise_speed = 1.5F;      // m/s, Wang14's s0
  std::optional<float> boundary;  // m, Wang14's d0; default one cell
  LimitsSpec limits;
  float radius = 0.05F;  // m, the body
  int mde_sweeps = 8;
  bool governor = true;
  std::string robots;  // the name of a HAL below
  Place place;         // of the swarm
  Place start_place;   // of its start
  Place goal_place;    // of its goal's name
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
};

struct HalSpec {
  std::string name;
  SimHalSpec sim;  // kind: sim is the only one so far
};

struct Expectation {
  enum class Quantity {
    kReached,
    kMinSeparation,
    kPenetrations,
    kCollisions,
    kMdePercent,
    kMaxSpeed,
    kMaxAcceleration,
    kGovernorInterventions,
    kMissed,
    kFaults
  };
  enum class Comparison { kGreaterEqual, kLessEqual, kEqual, kGreater, kLess };
  Quantity quantity = Quantity::kPenetrations;
  std::string swarm;  // kReached only: empty for all
  std::string goal;   // kReached only
  Comparison comparison = Comparison::kEqual;
  double wanted = 0.0;
  std::string text;  // as written, for the summary: "reached flies at exit"
};

struct ControlSpec {
  float rate = 100.0F;  // Hz
};

struct RecordSpec {
  float rate = 20.0F;  // Hz
};

// Read and kept, though nothing runs planners yet (Scenario::warnings says so).
struct PlannerSpec {
  std::string name;
  float rate = 0.0F;  // Hz
  Place place;
};

struct Scenario {
  std::filesystem::path file;
  std::string name;
  std::uint64_t seed = 1;
  double duration = 60.0;  // s
  WorldSpec world;
  std::vector<SwarmSpec> swarms;
  ControlSpec control;
  RecordSpec record;
  std::vector<HalSpec> hals;
  std::vector<Expectation> expect;
  std::vector<PlannerSpec> planners;
  std::vector<Error> warnings;  // what is odd but flies
};

}  // namespace mayfly
