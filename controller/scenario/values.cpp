#include "controller/scenario/values.hpp"

#include <algorithm>

#include "controller/scenario/numbers.hpp"
#include "controller/scenario/schema.hpp"

namespace mayfly {
namespace {

double number_in(std::string_view text) {
  return read_number(text).value.value_or(0.0);
}

glm::vec3 vector_of(const YamlNode* list) {
  glm::vec3 result(0.0F);
  for (int i = 0; list && i < 3; ++i) {
    result[i] = static_cast<float>(number_in(list->items[static_cast<std::size_t>(i)].text));
  }
  return result;
}

}  // namespace

std::string Values::key_path(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

YamlMark Values::mark(std::string_view key) const {
  const YamlNode* value = node(key);
  return value ? value->mark : map_ ? map_->mark : YamlMark{};
}

Values Values::map(std::string_view key) const {
  return {node(key), key_path(key)};
}

Values Values::element(std::string_view key, const YamlNode& element) const {
  const Key* row = find_key(key_path(key));
  return {&element, key_path(key) + (row && row->type == KeyType::kList ? "[]" : ".*")};
}

std::string Values::text(std::string_view key) const {
  if (const YamlNode* value = node(key)) {
    return value->text;
  }
  const Key* row = find_key(key_path(key));
  return row ? row->fallback : std::string();
}

double Values::number(std::string_view key) const {
  return number_in(text(key));
}

long long Values::integer(std::string_view key) const {
  return read_integer(text(key)).value_or(0);
}

bool Values::flag(std::string_view key) const {
  return read_flag(text(key)).value_or(false);
}

// The only default of a vector in the table is the origin.
glm::vec3 Values::vector(std::string_view key) const {
  return vector_of(node(key));
}

glm::vec3 Values::whole_vector() const {
  return vector_of(map_);
}

int Values::choice(std::string_view key) const {
  const Key* row = find_key(key_path(key));
  const auto found = std::find(row->choices.begin(), row->choices.end(), text(key));
  return static_cast<int>(found - row->choices.begin());
}

std::vector<Values::Name> Values::names(std::string_view key) const {
  std::vector<Name> names;
  const YamlNode* value = node(key);
  if (value != nullptr && value->kind == YamlNode::Kind::kScalar) {
    names.push_back({value->text, value->mark});
  }
  for (std::size_t i = 0; value != nullptr && i < value->items.size(); ++i) {
    names.push_back({value->items[i].text, value->items[i].mark});
  }
  return names;
}

std::optional<float> Values::maybe_number(std::string_view key) const {
  return has(key) ? std::optional(number_f(key)) : std::nullopt;
}

}  // namespace mayfly
