// Reads values out of a tree that check_tree() found nothing wrong with; what the file leaves out comes from
// the table.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/scenario/document.hpp"

namespace mayfly {

// One map of the file, or one that the file leaves out, and the table's path of it.
class Values {
 public:
  Values(const YamlNode* map, std::string path) : map_(map), path_(std::move(path)) {}

  // Null where the file leaves it out.
  const YamlNode* node(std::string_view key) const { return map_ ? map_->find(key) : nullptr; }
  bool has(std::string_view key) const { return node(key) != nullptr; }
  const std::string& path() const { return path_; }
  // Of the key's value, or of the map where the file leaves the key out.
  YamlMark mark(std::string_view key) const;

  Values map(std::string_view key) const;
  // Element of the list or of the named map that `key` is.
  Values element(std::string_view key, const YamlNode& element) const;

  // These give the table's default where the file has none; for a key without a default, 0 or "".
  double number(std::string_view key) const;
  float number_f(std::string_view key) const { return static_cast<float>(number(key)); }
  long long integer(std::string_view key) const;
  bool flag(std::string_view key) const;
  std::string text(std::string_view key) const;
  glm::vec3 vector(std::string_view key) const;
  // Of an element of a list of vectors: the element itself.
  glm::vec3 whole_vector() const;
  struct Name {
    std::string text;
    YamlMark mark;
  };
  std::vector<Name> names(std::string_view key) const;
  // Which of the table's choices, from 0.
  int choice(std::string_view key) const;

  std::optional<float> maybe_number(std::string_view key) const;

 private:
  std::string key_path(std::string_view key) const;

  const YamlNode* map_;
  std::string path_;
};

}  // namespace mayfly
