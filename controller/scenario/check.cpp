#include "controller/scenario/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "controller/scenario/numbers.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

using Kind = YamlNode::Kind;

// The top of a scenario has no row of its own: it has no name.
const Key kTop{.path = "", .type = KeyType::kMap, .text = "A scenario."};

std::string join(std::string_view path, std::string_view name) {
  return path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
}

bool is_name(std::string_view text) {
  constexpr std::size_t kLongest = 64;
  return !text.empty() && text.size() <= kLongest &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                  c == '-';
         });
}

class Checker {
 public:
  std::vector<Error> take() { return std::move(errors_); }

  void check(const YamlNode& node, const Key& key, const std::string& name) {
    if (full()) {
      return;
    }
    switch (key.type) {
      case KeyType::kMap:
        return check_map(node, key, name);
      case KeyType::kNamedMap:
        return check_named_map(node, key, name);
      case KeyType::kList:
        return check_list(node, key, name);
      case KeyType::kVector:
        return check_vector(node, key, name);
      case KeyType::kNames:
        return check_names(node, key, name);
      default:
        return check_scalar(node, key, name);
    }
  }

 private:
  bool full() const { return errors_.size() >= kMaxErrors; }
  void add(Error error) {
    if (!full()) {
      errors_.push_back(std::move(error));
    }
  }
  void add(const YamlNode& node, const Key& key, std::string message, std::string suggestion = {}) {
    add({.message = std::move(message),
         .place = node.mark.place(),
         .found = describe(node),
         .wanted = wanted_of(key),
         .suggestion = std::move(suggestion)});
  }
  void wrong_type(const YamlNode& node, const Key& key, const std::string& name) {
    add(node, key, fmt::format("'{}' is not of the right type", name));
  }

  void check_map(const YamlNode& node, const Key& key, const std::string& name) {
    if (node.kind != Kind::kMap) {
      return name.empty()
                 ? add(node, key, node.kind == Kind::kNull ? "the scenario is empty" : "this is no scenario")
                 : wrong_type(node, key, name);
    }
    for (const YamlEntry& entry : node.entries) {
      const Key* child = find_key(join(key.path, entry.key));
      if (child == nullptr) {
        add(unknown_key(entry.key, key.path, entry.mark));
      } else {
        check(entry.value, *child, entry.key);
        check_needs(node, entry, *child);
      }
      if (full()) {
        return;
      }
    }
    check_required(node, key);
    check_groups(node, key);
  }

  void check_needs(const YamlNode& map, const YamlEntry& entry, const Key& key) {
    if (!key.needs.empty() && map.find(key.needs) == nullptr) {
      add({.message = fmt::format("'{}' means nothing here", entry.key),
           .place = entry.mark.place(),
           .wanted = fmt::format("it only beside '{}'", key.needs)});
    }
  }

  void check_required(const YamlNode& map, const Key& key) {
    for (const Key* child : child_keys(key.path)) {
      const std::string name(last_name(child->path));
      if (child->required && map.find(name) == nullptr) {
        add({.message =
                 fmt::format("the key '{}' is missing{}", name, key.path.empty() ? "" : " in " + key.path),
             .place = map.mark.place(),
             .wanted = wanted_of(*child)});
      }
    }
  }

  void check_groups(const YamlNode& map, const Key& key) {
    std::vector<std::string> names;
    std::string group;
    for (const Key* child : child_keys(key.path)) {
      if (!child->group.empty()) {
        group = child->group;
        names.emplace_back(last_name(child->path));
      }
    }
    const std::string wanted = (names.size() > 1 ? "exactly one of " : "") + list_names(names);
    if (group.empty()) {
      return;
    }
    const YamlEntry* first = nullptr;
    for (const YamlEntry& entry : map.entries) {
      if (std::find(names.begin(), names.end(), entry.key) == names.end()) {
        continue;
      }
      if (first != nullptr) {
        add({.message = fmt::format("a second {} in one entry", group),
             .place = entry.mark.place(),
             .found = fmt::format("'{}' beside '{}'", entry.key, first->key),
             .wanted = wanted});
      }
      first = &entry;
    }
    if (first == nullptr) {
      add({.message = fmt::format("no {} is given", group), .place = map.mark.place(), .wanted = wanted});
    }
  }

  void check_named_map(const YamlNode& node, const Key& key, const std::string& name) {
    if (node.kind != Kind::kMap) {
      return wrong_type(node, key, name);
    }
    if (key.required && node.entries.empty()) {
      add(node, key, fmt::format("'{}' is empty", name));
    }
    const Key* child = find_key(key.path + ".*");
    for (const YamlEntry& entry : node.entries) {
      if (!is_name(entry.key)) {
        add({.message = fmt::format("'{}' is not a name", entry.key),
             .place = entry.mark.place(),
             .wanted = "a name of letters, digits, _ and -"});
      }
      check(entry.value, *child, entry.key);
    }
  }

  void check_list(const YamlNode& node, const Key& key, const std::string& name) {
    if (node.kind != Kind::kSequence) {
      return wrong_type(node, key, name);
    }
    if (node.items.empty() && (key.required || key.fallback.empty())) {
      add(node, key, fmt::format("'{}' is empty", name));
    }
    if (static_cast<double>(node.items.size()) > key.max) {
      return add(node, key, fmt::format("'{}' is too long", name));
    }
    if (!node.items.empty() && static_cast<double>(node.items.size()) < key.min) {
      add(node, key, fmt::format("'{}' is too short", name));
    }
    const Key* element = find_key(key.path + "[]");
    for (std::size_t i = 0; i < node.items.size() && !full(); ++i) {
      check(node.items[i], *element, fmt::format("{}[{}]", name, i));
    }
  }

  void check_vector(const YamlNode& node, const Key& key, const std::string& name) {
    if (node.kind != Kind::kSequence || node.items.size() != 3) {
      return wrong_type(node, key, name);
    }
    Key number = key;
    number.type = KeyType::kNumber;
    for (std::size_t i = 0; i < 3; ++i) {
      check_scalar(node.items[i], number, fmt::format("{}[{}]", name, i));
    }
  }

  void check_names(const YamlNode& node, const Key& key, const std::string& name) {
    const auto is_good = [](const YamlNode& n) { return n.kind == Kind::kScalar && is_name(n.text); };
    const bool is_list = node.kind == Kind::kSequence && !node.items.empty();
    if (!is_list && !is_good(node)) {
      return wrong_type(node, key, name);
    }
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      if (!is_good(node.items[i])) {
        wrong_type(node.items[i], key, fmt::format("{}[{}]", name, i));
      }
    }
  }

  void check_scalar(const YamlNode& node, const Key& key, const std::string& name) {
    if (key.list_later && node.kind == Kind::kSequence) {
      return add(node, key, fmt::format("a list for '{}' is not available in this version", name));
    }
    if (node.kind != Kind::kScalar) {
      return wrong_type(node, key, name);
    }
    switch (key.type) {
      case KeyType::kNumber:
        return node.quoted ? check_quoted(node, key, name) : check_number(node, node.text, key, name);
      case KeyType::kInteger:
        return node.quoted ? check_quoted(node, key, name) : check_integer(node, key, name);
      case KeyType::kComparison:
        return check_comparison(node, key, name);
      case KeyType::kChoice:
        return check_choice(node, key, name);
      case KeyType::kFlag:
        if (!read_flag(node.text) || node.quoted) {
          wrong_type(node, key, name);
        }
        return;
      case KeyType::kName:
        if (!is_name(node.text)) {
          wrong_type(node, key, name);
        }
        return;
      default:
        return check_text(node, key, name);
    }
  }

  void check_text(const YamlNode& node, const Key& key, const std::string& name) {
    constexpr std::size_t kLongest = 1000;
    if (node.text.empty() || node.text.size() > kLongest) {
      add(node, key, fmt::format("'{}' is {}", name, node.text.empty() ? "empty" : "longer than 1000 bytes"));
    }
  }

  // In quotes it is a text; what stands in the quotes is worth a better message all the same.
  void check_quoted(const YamlNode& node, const Key& key, const std::string& name) {
    const NumberText number = read_number(node.text);
    if (number.value && !number.rest.empty()) {
      return check_number(node, node.text, key, name);
    }
    add(node, key, fmt::format("'{}' is a text, not a number", name),
        number.value ? node.text : std::string());
  }

  void check_number(const YamlNode& node, std::string_view text, const Key& key, const std::string& name) {
    const NumberText number = read_number(text);
    if (number.value && !number.rest.empty()) {
      const auto converted = convert_unit(*number.value, number.rest, key.unit);
      return add(node, key,
                 fmt::format("'{}' has something behind its number, and units are not written", name),
                 converted ? fmt::format("{:.7g}", *converted) : std::string());
    }
    if (!number.value) {
      return add(node, key, fmt::format("'{}' is not a number", name));
    }
    if (!std::isfinite(*number.value)) {
      return add(node, key, fmt::format("'{}' is not finite", name));
    }
    check_range(node, *number.value, key, name);
  }

  void check_integer(const YamlNode& node, const Key& key, const std::string& name) {
    const auto value = read_integer(node.text);
    if (!value) {
      const bool has_unit = read_number(node.text).value && !read_number(node.text).rest.empty();
      return has_unit ? check_number(node, node.text, key, name)
                      : add(node, key, fmt::format("'{}' is not a whole number", name));
    }
    if (key.path == "mayfly" && *value != static_cast<long long>(key.max)) {
      return add(node, key, fmt::format("version {} of the scenario format is not known", *value));
    }
    check_range(node, static_cast<double>(*value), key, name);
  }

  void check_comparison(const YamlNode& node, const Key& key, const std::string& name) {
    const auto parts = read_comparison(node.text);
    if (!parts) {
      return add(node, key, fmt::format("'{}' does not start with >=, <=, ==, > or <", name));
    }
    check_number(node, parts->number, key, name);
  }

  void check_range(const YamlNode& node, double value, const Key& key, const std::string& name) {
    if (value < key.min || value > key.max || (key.above_min && value == key.min)) {
      add(node, key, fmt::format("'{}' is out of range", name));
    }
  }

  void check_choice(const YamlNode& node, const Key& key, const std::string& name) {
    const auto is_in = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), node.text) != names.end();
    };
    if (is_in(key.later)) {
      add(node, key, fmt::format("'{}: {}' is not available in this version", name, node.text));
    } else if (!is_in(key.choices)) {
      add(node, key, fmt::format("'{}' is none of the known values", name),
          nearest_name(node.text, key.choices));
    }
  }

  std::vector<Error> errors_;
};

}  // namespace

Error unknown_key(std::string_view name, std::string_view path, const YamlMark& mark) {
  std::vector<std::string> names;
  for (const Key* child : child_keys(path)) {
    names.emplace_back(last_name(child->path));
  }
  std::string suggestion = nearest_name(name, names);
  // A right name one level too high: "speed" of a swarm is "limits.speed".
  const std::string under = join(path, "");
  for (const Key& key : scenario_keys()) {
    if (suggestion.empty() && key.path.starts_with(under) && last_name(key.path) == name) {
      suggestion = key.path.substr(under.size());
    }
  }
  constexpr std::size_t kLongest = 60;
  return {.message = fmt::format("unknown key '{}'{}", name.substr(0, kLongest),
                                 path.empty() ? std::string() : fmt::format(" in {}", path)),
          .place = mark.place(),
          .wanted = "one of " + list_names(names),
          .suggestion = suggestion};
}

std::vector<Error> check_tree(const YamlNode& root) {
  Checker checker;
  checker.check(root, kTop, "");
  return checker.take();
}

}  // namespace mayfly
