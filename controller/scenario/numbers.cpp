#include "controller/scenario/numbers.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <utility>

namespace mayfly {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

std::string_view without_spaces(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// YAML's own spellings of what is not finite.
std::optional<double> read_special(std::string_view text) {
  const bool negative = text.starts_with('-');
  const std::string word = lower(negative || text.starts_with('+') ? text.substr(1) : text);
  if (word == ".nan") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (word == ".inf") {
    return negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  }
  return std::nullopt;
}

struct Unit {
  std::string_view name;
  std::string_view base;
  double factor;
};
constexpr std::array kUnits = {
    Unit{"m", "m", 1.0},
    Unit{"mm", "m", 1e-3},
    Unit{"cm", "m", 1e-2},
    Unit{"dm", "m", 0.1},
    Unit{"km", "m", 1e3},
    Unit{"s", "s", 1.0},
    Unit{"ms", "s", 1e-3},
    Unit{"us", "s", 1e-6},
    Unit{"min", "s", 60.0},
    Unit{"h", "s", 3600.0},
    Unit{"Hz", "Hz", 1.0},
    Unit{"kHz", "Hz", 1e3},
    Unit{"m/s", "m/s", 1.0},
    Unit{"cm/s", "m/s", 1e-2},
    Unit{"mm/s", "m/s", 1e-3},
    Unit{"km/h", "m/s", 1 / 3.6},
    Unit{"m/s²", "m/s²", 1.0},
    Unit{"m/s^2", "m/s²", 1.0},
    Unit{"m/s2", "m/s²", 1.0},
    Unit{"m²/s", "m²/s", 1.0},
    Unit{"m^2/s", "m²/s", 1.0},
    Unit{"deg", "degrees", 1.0},
    Unit{"degrees", "degrees", 1.0},
    Unit{"°", "degrees", 1.0},
    Unit{"%", "%", 1.0},
    Unit{"1/m", "1/m", 1.0},
    Unit{"1/s", "1/s", 1.0},
};

const Unit* find_unit(std::string_view name) {
  for (const Unit& unit : kUnits) {
    if (unit.name == name) {
      return &unit;
    }
  }
  return nullptr;
}

}  // namespace

NumberText read_number(std::string_view text) {
  text = without_spaces(text);
  if (const auto special = read_special(text)) {
    return {special, {}};
  }
  std::string_view digits = text;
  if (digits.starts_with('+')) {
    digits.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (problem == std::errc::invalid_argument || (text.starts_with('+') && digits.starts_with('-'))) {
    return {std::nullopt, std::string(text)};
  }
  const std::string rest(
      without_spaces({end, static_cast<std::size_t>(digits.data() + digits.size() - end)}));
  return {problem == std::errc() ? std::optional(value) : std::nullopt, rest};
}

std::optional<long long> read_integer(std::string_view text) {
  text = without_spaces(text);
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);
  }
  long long value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<bool> read_flag(std::string_view text) {
  const std::string word = lower(text);
  if (word == "on" || word == "true" || word == "yes") {
    return true;
  }
  if (word == "off" || word == "false" || word == "no") {
    return false;
  }
  return std::nullopt;
}

std::optional<ComparisonText> read_comparison(std::string_view text) {
  using Comparison = Expectation::Comparison;
  // The longer spellings first, so that ">=" is not read as ">".
  constexpr std::array<std::pair<std::string_view, Comparison>, 5> kSpellings = {{
      {">=", Comparison::kGreaterEqual},
      {"<=", Comparison::kLessEqual},
      {"==", Comparison::kEqual},
      {">", Comparison::kGreater},
      {"<", Comparison::kLess},
  }};
  text = without_spaces(text);
  for (const auto& [spelling, comparison] : kSpellings) {
    if (text.starts_with(spelling)) {
      return ComparisonText{comparison, without_spaces(text.substr(spelling.size()))};
    }
  }
  return std::nullopt;
}

std::optional<double> convert_unit(double value, std::string_view from, std::string_view to) {
  const Unit* source = find_unit(from);
  const Unit* target = find_unit(to);
  if (source == nullptr || target == nullptr || source->base != target->base) {
    return std::nullopt;
  }
  return value * source->factor / target->factor;
}

}  // namespace mayfly
