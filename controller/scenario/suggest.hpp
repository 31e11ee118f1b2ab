// "did you mean": the valid name that is nearest to what was typed.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace mayfly {

// Fewest insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The nearest of `names`, or nothing where none is near enough to be meant. Capitals and hyphens are
// forgiven.
std::string nearest_name(std::string_view typed, std::span<const std::string> names);

// "a, b or c"; long lists are cut.
std::string list_names(std::span<const std::string> names);

}  // namespace mayfly
