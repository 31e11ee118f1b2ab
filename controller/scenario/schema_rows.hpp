// The rows of the table in schema.hpp.
#pragma once

#include <vector>

#include "controller/scenario/schema.hpp"

namespace mayfly {

std::vector<Key> schema_rows();

// What every shape of the world is described with; `path` is the map that holds exactly one of them.
enum class ShapeSet { kObstacle, kGoal, kStart };
void add_shape_rows(std::vector<Key>& rows, const std::string& path, ShapeSet set);

}  // namespace mayfly
