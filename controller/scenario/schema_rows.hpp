// The rows of the table in schema.hpp.
#pragma once

#include <string>
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
void add_fault_rows(std::vector<Key>& rows);
void add_twin_rows(std::vector<Key>& rows);
// What moves the swarm whose rows are `at`, and who of it is there.
void add_model_rows(std::vector<Key>& rows, const std::string& at);

// What every shape of the world is described with; `path` is the map that holds exactly one of them.
enum class ShapeSet { kObstacle, kGoal, kStart };
void add_shape_rows(std::vector<Key>& rows, const std::string& path, ShapeSet set);
// How it moves.
void add_path_rows(std::vector<Key>& rows, const std::string& path);
// Which swarm feels what `path` is.
void add_swarm_of_row(std::vector<Key>& rows, const std::string& path);

}  // namespace mayfly
