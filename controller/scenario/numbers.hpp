// How the numbers, flags and comparisons of a scenario are written.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "controller/scenario/scenario.hpp"

namespace mayfly {

// A number at the start of a text, and what stands behind it ("1.5 m" → 1.5 and "m"). The value is empty
// where there is no number, or where a double cannot hold it; it may be infinite or NaN (".inf", "nan").
struct NumberText {
  std::optional<double> value;
  std::string rest;
};
NumberText read_number(std::string_view text);

// The digits of a whole number, nothing else.
std::optional<long long> read_integer(std::string_view text);

// on, off, true, false, yes, no, in any capitals.
std::optional<bool> read_flag(std::string_view text);

// ">= 0.99" → the comparison and "0.99".
struct ComparisonText {
  Expectation::Comparison comparison;
  std::string_view number;
};
std::optional<ComparisonText> read_comparison(std::string_view text);

// `value`, given in the unit `from`, in the unit `to`; empty where they don't measure the same, or aren't
// known.
std::optional<double> convert_unit(double value, std::string_view from, std::string_view to);

}  // namespace mayfly
