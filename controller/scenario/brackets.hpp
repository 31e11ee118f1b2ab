// A better word than a parser's for the two slips that people make most in YAML: brackets and tabs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mayfly {

struct YamlSlip {
  int line = 0;
  int column = 0;
  std::string message;
  std::string wanted;
};

// Looks through a text that is known not to parse, up to `last_line` for tabs. Finds nothing where the reason
// is another.
std::optional<YamlSlip> find_yaml_slip(std::string_view text, int last_line);

}  // namespace mayfly
