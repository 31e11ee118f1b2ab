// Names that a scenario gives to its parts, and keys that refer to them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "controller/scenario/build.hpp"

namespace mayfly {

template <class Specs>
std::vector<std::string> names_of(const Specs& specs) {
  std::vector<std::string> names;
  names.reserve(specs.size());
  for (const auto& spec : specs) {
    names.push_back(spec.name);
  }
  return names;
}

// Which of `names` the text of `key` is; an error, and 0, where it is none ("there is no goal 'exti'").
std::size_t find_named(const Values& values, std::string_view key, const std::vector<std::string>& names,
                       std::string_view what, Findings& findings);

// Where parts with names of their own are listed: an error at the name of each that came before.
class UniqueNames {
 public:
  explicit UniqueNames(std::string_view what) : what_(what) {}
  void add(const Values& values, Findings& findings);

 private:
  std::string what_;
  std::vector<std::pair<std::string, Place>> places_;
};

}  // namespace mayfly
