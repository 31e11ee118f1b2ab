// Which files a scenario may name, and how they are found.
//
// A path in a scenario is relative to the scenario's folder, and after every symbolic link is resolved it
// must lie in that folder or in the project: the nearest folder above the scenario that holds a file
// `mayfly.project` or a `.git`. Only a person at the command line (--set) may name any other file,
// absolutely.
#pragma once

#include <filesystem>
#include <string>

#include "controller/scenario/document.hpp"
#include "core/result.hpp"

namespace mayfly {

struct FileRoots {
  std::filesystem::path scenario;  // the folder of the scenario
  std::filesystem::path project;   // empty where there is none

  bool contain(const std::filesystem::path& canonical) const;
};

// Absolute and free of symbolic links, as far as the folders exist.
FileRoots find_roots(const std::filesystem::path& scenario_file);

// The regular file that the text of `node` names, absolute, or what is wrong with it, at the node's place.
Result<std::filesystem::path> resolve_file(const YamlNode& node, const FileRoots& roots);

// The whole text of a regular file of at most kMaxYamlBytes bytes.
Result<std::string> read_text_file(const std::filesystem::path& file);

// The name in the same folder that is nearest to the file's own name; empty where none is near.
std::string near_file_name(const std::filesystem::path& file);

}  // namespace mayfly
