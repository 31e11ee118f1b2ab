// `--set path.to.key=value`: changes to a scenario's tree before it is checked, so that a value from the
// command line goes through the same checks as one from the file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/scenario/document.hpp"

namespace mayfly {

struct Override {
  std::string path;   // "swarms.flies.count", "swarms.0.count", "world.bounds.max.2"
  std::string value;  // YAML
};

// From "path=value".
Result<Override> parse_override(std::string_view text);

// Applies those that can be; the others come back as errors whose place is the override itself. Elements of a
// list are addressed by number or by their `name`. Maps on the way are made where they are missing and the
// table allows it.
std::vector<Error> apply_overrides(YamlNode& root, std::span<const Override> overrides);

}  // namespace mayfly
