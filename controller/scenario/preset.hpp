// `preset: wang14/two_blocks`: a file of swarm keys that are defaults for the swarm which names it.
//
// Looked for in the project's config/presets first, then among those that are built into the program.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "controller/scenario/document.hpp"
#include "controller/scenario/files.hpp"

namespace mayfly {

// Puts each swarm's preset under its own keys, throughout the tree. Keys keep the place where they are
// written.
std::vector<Error> apply_presets(YamlNode& root, const FileRoots& roots);

// The built-in presets: name → text.
const std::map<std::string, std::string>& builtin_presets();

}  // namespace mayfly
