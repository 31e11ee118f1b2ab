// A tree against the table of keys: unknown and missing keys, types, units and ranges.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "controller/scenario/document.hpp"
#include "controller/scenario/schema.hpp"

namespace mayfly {

// A person mends a handful of errors at a time, and a hostile file could have a hundred thousand.
inline constexpr std::size_t kMaxErrors = 50;

// Everything in which `root`, a whole scenario, differs from the table; empty if nothing does.
std::vector<Error> check_tree(const YamlNode& root);

// The error of a name that the map at `path` does not have, with the nearest that it has.
Error unknown_key(std::string_view name, std::string_view path, const YamlMark& mark);

}  // namespace mayfly
