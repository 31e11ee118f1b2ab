#include <cmath>
#include <nlohmann/json.hpp>

#include "controller/scenario/numbers.hpp"
#include "controller/scenario/schema.hpp"
#include "controller/scenario/schema_export.hpp"

namespace mayfly {
namespace {

using Json = nlohmann::ordered_json;

Json schema_of(const Key& key);

Json number_json(double value) {
  return std::floor(value) == value && std::abs(value) < 1e16 ? Json(static_cast<long long>(value))
                                                              : Json(value);
}

void add_range(Json& schema, const Key& key) {
  if (std::isfinite(key.min)) {
    schema[key.above_min ? "exclusiveMinimum" : "minimum"] = number_json(key.min);
  }
  if (std::isfinite(key.max)) {
    schema["maximum"] = number_json(key.max);
  }
}

// The keys of a map, and what must and must not stand beside what.
void add_properties(Json& schema, std::string_view path) {
  schema["type"] = "object";
  schema["additionalProperties"] = false;
  Json properties = Json::object();
  Json required = Json::array();
  Json one_of = Json::array();
  Json needs = Json::object();
  for (const Key* child : child_keys(path)) {
    const std::string name(last_name(child->path));
    properties[name] = schema_of(*child);
    if (child->required) {
      required.push_back(name);
    }
    if (!child->group.empty()) {
      one_of.push_back({{"required", {name}}});
    }
    if (!child->needs.empty()) {
      needs[name] = {child->needs};
    }
  }
  schema["properties"] = std::move(properties);
  for (auto& [word, value] : {std::pair<const char*, Json&>{"required", required},
                              {"oneOf", one_of},
                              {"dependentRequired", needs}}) {
    if (!value.empty()) {
      schema[word] = std::move(value);
    }
  }
}

void add_list(Json& schema, const Key& key) {
  schema["type"] = "array";
  schema["items"] = schema_of(*find_key(key.path + "[]"));
  if (key.required || key.fallback.empty()) {
    schema["minItems"] = std::isfinite(key.min) ? number_json(key.min) : Json(1);
  }
  if (std::isfinite(key.max)) {
    schema["maxItems"] = number_json(key.max);
  }
}

void add_named_map(Json& schema, const Key& key) {
  schema["type"] = "object";
  schema["propertyNames"] = {{"pattern", "^[A-Za-z0-9_-]{1,64}$"}};
  schema["additionalProperties"] = schema_of(*find_key(key.path + ".*"));
  if (key.required) {
    schema["minProperties"] = 1;
  }
}

void add_type(Json& schema, const Key& key) {
  switch (key.type) {
    case KeyType::kMap:
      return add_properties(schema, key.path);
    case KeyType::kNamedMap:
      return add_named_map(schema, key);
    case KeyType::kList:
      return add_list(schema, key);
    case KeyType::kText:
    case KeyType::kFile:
      schema["type"] = {"string", "number", "boolean"};  // 42 and on are texts where a text is wanted
      return;
    case KeyType::kName:
      schema["type"] = {"string", "integer"};
      schema["pattern"] = "^[A-Za-z0-9_-]{1,64}$";
      return;
    case KeyType::kNames: {
      const Json name = {{"type", {"string", "integer"}}, {"pattern", "^[A-Za-z0-9_-]{1,64}$"}};
      const Json list = {{"type", "array"}, {"items", name}, {"minItems", 1}};
      schema["anyOf"] = Json::array({name, list});
      return;
    }
    case KeyType::kInteger:
    case KeyType::kNumber:
      schema["type"] = key.type == KeyType::kInteger ? "integer" : "number";
      return add_range(schema, key);
    case KeyType::kVector: {
      Json number = {{"type", "number"}};
      add_range(number, key);
      schema["type"] = "array";
      schema["items"] = std::move(number);
      schema["minItems"] = schema["maxItems"] = 3;
      return;
    }
    case KeyType::kFlag:
      schema["enum"] = {true, false, "on", "off", "yes", "no"};
      return;
    case KeyType::kChoice:
      schema["enum"] = key.choices;
      return;
    case KeyType::kComparison:
      schema["type"] = "string";
      schema["pattern"] = "^\\s*(>=|<=|==|>|<)\\s*[-+.0-9eE]+\\s*$";
      return;
  }
}

Json default_of(const Key& key) {
  if (key.type == KeyType::kFlag) {
    return read_flag(key.fallback).value_or(false);
  }
  if (key.type == KeyType::kChoice || key.type == KeyType::kText) {
    return key.fallback;
  }
  return Json::parse(key.fallback);
}

Json schema_of(const Key& key) {
  Json schema;
  schema["description"] = key.text + (key.unit.empty() ? "" : " [" + key.unit + "]");
  add_type(schema, key);
  if (!key.fallback.empty()) {
    schema["default"] = default_of(key);
  }
  return schema;
}

}  // namespace

std::string scenario_json_schema() {
  Json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "mayfly scenario";
  schema["description"] =
      "Made by mayfly_schema_gen from controller/scenario/schema_rows.cpp: change it there.";
  add_properties(schema, "");
  return schema.dump(2) + "\n";
}

}  // namespace mayfly
