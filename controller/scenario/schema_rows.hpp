// The rows of the table in schema.hpp.
#pragma once

#include <vector>

#include "controller/scenario/schema.hpp"

namespace mayfly {

// m from the origin: float32 resolves 1 mm there; farther out, agents would visibly snap.
inline constexpr double kFarthest = 10'000.0;

std::vector<Key> schema_rows();

void add_world_rows(std::vector<Key>& rows);
void add_swarm_rows(std::vector<Key>& rows);
void add_stimulus_rows(std::vector<Key>& rows);
void add_expect_rows(std::vector<Key>& rows);

// What every shape of the world is described with; `path` is the map that holds exactly one of them.
enum class ShapeSet { kObstacle, kGoal, kStart };
void add_shape_rows(std::vector<Key>& rows, const std::string& path, ShapeSet set);

}  // namespace mayfly
