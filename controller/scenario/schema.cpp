#include "controller/scenario/schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>

#include "controller/scenario/schema_rows.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

std::string parent_of(std::string_view path) {
  if (path.ends_with("[]")) {
    return std::string(path.substr(0, path.size() - 2));
  }
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string() : std::string(path.substr(0, dot));
}

struct Index {
  std::map<std::string, const Key*, std::less<>> by_path;
  std::map<std::string, std::vector<const Key*>, std::less<>> children;
};

const Index& index() {
  static const Index kBuilt = [] {
    Index index;
    for (const Key& key : scenario_keys()) {
      index.by_path.emplace(key.path, &key);
      index.children[parent_of(key.path)].push_back(&key);
    }
    return index;
  }();
  return kBuilt;
}

std::string range_of(const Key& key) {
  if (key.min == key.max) {
    return fmt::format(", {:g}", key.min);
  }
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const std::string low = fmt::format("{}{:.16g}", key.above_min ? "above " : "from ", key.min);
  if (key.min > -kNone && key.max < kNone) {
    return fmt::format(", {} to {:.16g}", low, key.max);
  }
  return key.min > -kNone ? ", " + low : std::string();
}

}  // namespace

const std::vector<Key>& scenario_keys() {
  static const std::vector<Key> kKeys = schema_rows();
  return kKeys;
}

const Key* find_key(std::string_view path) {
  const auto it = index().by_path.find(path);
  return it == index().by_path.end() ? nullptr : it->second;
}

const std::vector<const Key*>& child_keys(std::string_view path) {
  static const std::vector<const Key*> kNone;
  const auto it = index().children.find(path);
  return it == index().children.end() ? kNone : it->second;
}

std::string_view last_name(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::string wanted_of(const Key& key) {
  const std::string unit = key.unit.empty() ? "" : " in " + key.unit;
  switch (key.type) {
    case KeyType::kMap:
      return "a map with the keys of " + (key.path.empty() ? std::string("a scenario") : key.path);
    case KeyType::kNamedMap:
      return "a map of names";
    case KeyType::kList:
      if (std::isfinite(key.min)) {
        return fmt::format("a list of {:.16g} to {:.16g}", key.min, key.max);
      }
      return key.max < std::numeric_limits<double>::infinity()
                 ? fmt::format("a list of at most {:.16g}", key.max)
                 : "a list";
    case KeyType::kText:
      return "a text";
    case KeyType::kName:
      return "a name of letters, digits, _ and -";
    case KeyType::kFile:
      return "the path of a file";
    case KeyType::kNames:
      return "a name, or a list of names";
    case KeyType::kInteger:
      return "a whole number" + unit + range_of(key);
    case KeyType::kNumber:
      return "a number" + unit + range_of(key);
    case KeyType::kVector:
      return "a list of 3 numbers" + unit + range_of(key);
    case KeyType::kFlag:
      return "on or off";
    case KeyType::kChoice:
      return list_names(key.choices);
    case KeyType::kComparison:
      return "a comparison such as \">= 0.5\", with a number" + unit + range_of(key);
  }
  return {};
}

}  // namespace mayfly
