// The one table of a scenario's keys. The checks (check.cpp), the values the loader reads (values.cpp), the
// JSON schema and the reference page (schema_json.cpp, schema_page.cpp) all come from it.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace mayfly {

enum class KeyType {
  kMap,       // fixed keys, each a row of its own
  kNamedMap,  // keys are names that the user gives; what is under each is the row "PATH.*"
  kList,      // its elements are the row "PATH[]"
  kText,
  kNames,  // a name, or a list of names
  kName,   // letters, digits, _ and -: what --set can address
  kFile,
  kInteger,
  kNumber,
  kVector,  // three numbers
  kFlag,
  kChoice,
  kComparison,  // a text such as ">= 0.2"
};

struct Key {
  // From the top: "swarms[].noise.scale"; [] is any element of a list, * any name the user gives.
  std::string path;
  KeyType type = KeyType::kMap;
  std::string unit{};                                     // "" is a pure number
  double min = -std::numeric_limits<double>::infinity();  // of a list: how many elements
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;  // `min` itself is out
  bool required = false;
  std::string fallback{};              // the default, as YAML; "" is none
  std::string fallback_text{};         // the default in words, where it is not a constant
  std::vector<std::string> choices{};  // kChoice
  std::vector<std::string> later{};    // kChoice: known, but not in this version
  std::string group{};                 // of the siblings with the same group, exactly one is given
  std::string needs{};                 // a sibling without which the key means nothing
  bool list_later = false;             // a list of values instead of one is known, but not in this version
  std::string text;                    // one sentence
};

// Every key, parents before children, in the order of the reference page.
const std::vector<Key>& scenario_keys();

// The row of a path such as "world.obstacles[].mesh"; null where there is none.
const Key* find_key(std::string_view path);

// The rows right under a path ("" for the top), in the table's order.
const std::vector<const Key*>& child_keys(std::string_view path);

// "cell" of "world.cell".
std::string_view last_name(std::string_view path);

// What the row wants, for a message: "a number in m, from 0.001 to 1000".
std::string wanted_of(const Key& key);

}  // namespace mayfly
