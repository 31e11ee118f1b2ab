// RVO2-3D beside our avoidance: something only where its sources are at hand.
#ifdef MAYFLY_HAS_RVO2_3D
#include <RVO.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "bench/forces/even_swarm.hpp"

namespace mayfly::bench {
namespace {

// Ten bits of each coordinate, one after the other.
std::uint64_t morton_key(const EvenSwarm& swarm, std::size_t agent) {
  constexpr int kBits = 10;
  const auto cell = [&](float at) {
    return static_cast<std::uint64_t>(std::clamp(at / swarm.side, 0.0F, 0.999F) * (1 << kBits));
  };
  const std::uint64_t x = cell(swarm.x[agent]), y = cell(swarm.y[agent]), z = cell(swarm.z[agent]);
  std::uint64_t key = 0;
  for (int bit = kBits - 1; bit >= 0; --bit) {
    const auto shift = static_cast<unsigned>(bit);
    key = key << 3U | (x >> shift & 1U) | (y >> shift & 1U) << 1U | (z >> shift & 1U) << 2U;
  }
  return key;
}

}  // namespace

struct Rvo2Swarm::State {
  explicit State(const EvenSwarm& even)
      : swarm(even),
        order(even.x.size()),
        simulator(EvenSwarm::kPeriod, EvenSwarm::kRange, EvenSwarm::kNeighbours, EvenSwarm::kHorizon,
                  EvenSwarm::kRadius, EvenSwarm::kMostSpeed) {}
  const EvenSwarm& swarm;
  std::vector<std::size_t> order;
  RVO::RVOSimulator simulator;
};

Rvo2Swarm::Rvo2Swarm(const EvenSwarm& swarm, int threads, bool morton)
    : state_(std::make_unique<State>(swarm)) {
  omp_set_num_threads(threads);
  std::vector<std::size_t>& order = state_->order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (morton) {
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return morton_key(swarm, a) < morton_key(swarm, b); });
  }
  for (const std::size_t agent : order) {
    state_->simulator.addAgent(RVO::Vector3(swarm.x[agent], swarm.y[agent], swarm.z[agent]));
  }
}

Rvo2Swarm::~Rvo2Swarm() = default;

double Rvo2Swarm::step_seconds() {
  const EvenSwarm& swarm = state_->swarm;
  RVO::RVOSimulator& simulator = state_->simulator;
  for (std::size_t n = 0; n < state_->order.size(); ++n) {
    const std::size_t agent = state_->order[n];
    simulator.setAgentPosition(n, RVO::Vector3(swarm.x[agent], swarm.y[agent], swarm.z[agent]));
    simulator.setAgentVelocity(n, RVO::Vector3(swarm.vx[agent], swarm.vy[agent], swarm.vz[agent]));
    simulator.setAgentPrefVelocity(n, RVO::Vector3(swarm.wish.x, swarm.wish.y, swarm.wish.z));
  }
  const auto start = std::chrono::steady_clock::now();
  simulator.doStep();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace mayfly::bench
#endif
