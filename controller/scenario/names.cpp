#include "controller/scenario/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "controller/scenario/suggest.hpp"

namespace mayfly {

std::size_t find_named(const Values& values, std::string_view key, const std::vector<std::string>& names,
                       std::string_view what, Findings& findings) {
  const std::string name = values.text(key);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) {
    return static_cast<std::size_t>(found - names.begin());
  }
  findings.error(values.mark(key), fmt::format("there is no {} '{}'", what, name), "",
                 names.empty() ? "" : "one of " + list_names(names), nearest_name(name, names));
  return 0;
}

void UniqueNames::add(const Values& values, Findings& findings) {
  const std::string name = values.text("name");
  const auto first =
      std::find_if(places_.begin(), places_.end(), [&](const auto& known) { return known.first == name; });
  if (first == places_.end()) {
    places_.emplace_back(name, values.mark("name").place());
    return;
  }
  findings.error(values.mark("name"), fmt::format("a second {} '{}'", what_, name),
                 fmt::format("the first at {}:{}", first->second.line, first->second.column), "another name");
}

}  // namespace mayfly
