// Which folder may include which (docs/explanation/architecture.md), checked on the text of the sources.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mayfly::house {

// Every break of the rules below `top`, as "file:line: what". Quoted includes must start at the top of the
// tree, with a folder that the including file's folder may look into.
std::vector<std::string> wrong_includes(const std::filesystem::path& top);

}  // namespace mayfly::house
