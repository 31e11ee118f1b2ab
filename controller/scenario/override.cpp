#include "controller/scenario/override.hpp"

#include <fmt/format.h>

#include <optional>

#include "controller/scenario/check.hpp"
#include "controller/scenario/numbers.hpp"
#include "controller/scenario/schema.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

using Kind = YamlNode::Kind;

// Goes down the tree and the table together, one part of the dotted path at a time.
class Walk {
 public:
  Walk(YamlNode& root, YamlMark mark) : node_(&root), mark_(std::move(mark)) {}

  std::optional<Error> step(const std::string& part, bool is_last) {
    const Key* key = path_.empty() ? nullptr : find_key(path_);
    const KeyType type = key ? key->type : path_.empty() ? KeyType::kMap : KeyType::kNumber;
    switch (type) {
      case KeyType::kMap:
        return step_map(part);
      case KeyType::kNamedMap:
        return step_named_map(part, is_last);
      case KeyType::kList:
      case KeyType::kVector:
        return step_list(part);
      default:
        return error(fmt::format("there is nothing under '{}'", path_), "the path to end there");
    }
  }

  YamlNode& node() const { return *node_; }

 private:
  Error error(std::string message, std::string wanted, std::string suggestion = {}) const {
    return {.message = std::move(message),
            .place = mark_.place(),
            .wanted = std::move(wanted),
            .suggestion = std::move(suggestion)};
  }

  // The value of `name`, made where it is missing. What is no map is left for the checks to refuse.
  std::optional<Error> enter(const std::string& name) {
    if (node_->kind == Kind::kNull) {
      node_->kind = Kind::kMap;
    }
    if (node_->kind != Kind::kMap) {
      return error(fmt::format("'{}' is not a map in the file", path_), "a map, to set a key of it");
    }
    YamlNode* value = node_->find(name);
    if (value == nullptr) {
      YamlNode nothing;
      nothing.mark = mark_;
      node_->entries.push_back({name, mark_, std::move(nothing)});
      value = &node_->entries.back().value;
    }
    node_ = value;
    return std::nullopt;
  }

  std::optional<Error> step_map(const std::string& part) {
    const std::string path = path_.empty() ? part : path_ + "." + part;
    if (find_key(path) == nullptr) {
      return unknown_key(part, path_, mark_);
    }
    auto problem = enter(part);
    path_ = path;
    return problem;
  }

  std::optional<Error> step_named_map(const std::string& part, bool is_last) {
    std::vector<std::string> names;
    for (const YamlEntry& entry : node_->entries) {
      names.push_back(entry.key);
    }
    if (!is_last && node_->find(part) == nullptr) {
      return error(fmt::format("'{}' has no '{}'", path_, part), "one of " + list_names(names),
                   nearest_name(part, names));
    }
    auto problem = enter(part);
    path_ += ".*";
    return problem;
  }

  std::optional<Error> step_list(const std::string& part) {
    std::vector<std::string> names;
    for (YamlNode& item : node_->items) {
      const YamlNode* name = item.find("name");
      if (name == nullptr || name->kind != Kind::kScalar) {
        continue;
      }
      if (name->text == part) {
        return enter_item(item);
      }
      names.push_back(name->text);
    }
    const auto index = read_integer(part);
    if (index && *index >= 0 && static_cast<std::size_t>(*index) < node_->items.size()) {
      return enter_item(node_->items[static_cast<std::size_t>(*index)]);
    }
    const std::size_t size = node_->items.size();
    std::string wanted = size == 0 ? "nothing, it is empty" : fmt::format("a number from 0 to {}", size - 1);
    wanted += names.empty() ? "" : ", or " + list_names(names);
    return error(fmt::format("'{}' has no element '{}'", path_, part), wanted, nearest_name(part, names));
  }

  std::optional<Error> enter_item(YamlNode& item) {
    node_ = &item;
    path_ += "[]";
    return std::nullopt;
  }

  YamlNode* node_;
  std::string path_;  // in the table
  YamlMark mark_;
};

std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> parts(1);
  for (const char c : path) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::optional<Error> apply(YamlNode& root, const Override& change) {
  YamlMark mark;
  mark.file = std::make_shared<const std::string>("--set " + change.path + "=" + change.value);
  mark.command_line = true;
  auto value = parse_yaml_value(change.value, mark);
  if (!value) {
    return value.error();
  }
  if (value->kind == Kind::kNull) {
    value->mark = mark;
  }
  // Into a copy: an override that cannot be followed to its end must not leave half a path behind.
  YamlNode changed = root;
  Walk walk(changed, mark);
  const std::vector<std::string> parts = split(change.path);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (auto problem = walk.step(parts[i], i + 1 == parts.size())) {
      return problem;
    }
  }
  walk.node() = std::move(*value);
  root = std::move(changed);
  return std::nullopt;
}

}  // namespace

Result<Override> parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    return fail({.message = "this is not an override",
                 .place = Place{"--set " + std::string(text), 0, 0},
                 .wanted = "path.to.key=value, such as swarms.flies.count=10"});
  }
  return Override{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

std::vector<Error> apply_overrides(YamlNode& root, std::span<const Override> overrides) {
  std::vector<Error> errors;
  for (const Override& change : overrides) {
    if (auto problem = apply(root, change)) {
      errors.push_back(std::move(*problem));
    }
  }
  return errors;
}

}  // namespace mayfly
