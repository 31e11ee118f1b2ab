// The locusts' world with any number of agents, any cell and meshes of any fineness; always built, never
// cached.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "bench/common/ticks.hpp"
#include "controller/flight/prepare.hpp"

namespace mayfly::bench {

struct VillagePlan {
  std::size_t agents = 5000;
  // In the paper's start region, or all over the world: where a quarter of a million locusts would be.
  bool everywhere = false;
  float cell = 1.0F;     // m
  int subdivisions = 0;  // of every triangle into four, so often
  int threads = 2;       // of the field builders
};

struct Village {
  Scenario scenario;
  std::unique_ptr<const Prepared> ready;
};

tl::expected<Village, std::vector<Error>> make_village(const VillagePlan& plan);

// Points into the village.
Flock flock_of(const Village& village);

}  // namespace mayfly::bench
