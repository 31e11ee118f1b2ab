// How much memory a scenario's fields take, and how much the machine has.
#pragma once

#include <optional>
#include <string_view>

#include "controller/scenario/scenario.hpp"

namespace mayfly {

// Whatever the machine has: fields larger than this (bytes) are taken for a slip in a unit.
inline constexpr double kMaxFieldBytes = 4e9;

// What all fields of a scenario take for each cell of their grid, bytes, at the worst moment of building
// them.
double field_bytes_per_cell(const Scenario& scenario);

// What a program may still ask for, bytes: the least of the machine's and its control group's; empty where
// neither says so.
std::optional<double> available_memory();

// From the text of /proc/meminfo.
std::optional<double> available_in(std::string_view meminfo);

}  // namespace mayfly
