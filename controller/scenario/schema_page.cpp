#include <fmt/format.h>

#include <cmath>

#include "controller/scenario/schema.hpp"
#include "controller/scenario/schema_export.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

constexpr const char* kIntroduction = R"(# Scenario reference

<!-- Made by mayfly_schema_gen from controller/scenario/schema_rows.cpp: change it there. -->

A scenario is one YAML file: the world, who flies in it, on which robots, and what the run is held to. All values are in
SI units, without the unit written behind them; the world's frame is x east, y north, z up.

In the tables, `[]` stands for any element of a list and `*` for a name that you choose (letters, digits, `_` and `-`).
A bold key is required. Numbers must be finite.

What is checked beyond single keys: boxes are not empty; goals, HALs, stimuli and swarms that are named exist, and no name
is given twice; starts lie inside the bounds, and have room for their agents at `limits.separation`; a goal that moves stays
inside the bounds all the way, which an obstacle need not; brushes and stimuli that stand still reach into the bounds; no
swarm feels more than 16 lamps and `potential` brushes, or, of the model `forces`, more than 8 stimuli, and what is not a
lamp is felt by a swarm of that model; no more agents join or leave than there are; the cruise speed is within
`limits.speed`; a plant is stepped at least at the control rate; the fields take at most 4 GB, and no more than the machine
has left; all swarms together have at most 2 000 000 agents.

## Files
Paths are relative to the scenario's folder. With symbolic links resolved, they must stay in that folder or in the project:
the nearest folder above the scenario that holds a file `mayfly.project` or a `.git`. Only `--set` on the command line may
name any other file, by its absolute path.

A preset is looked for in the project's `config/presets/` first, then among those built into the program. Its keys are
defaults of the swarm that names it: the swarm's own keys win.

## Changing values from the command line
`--set path=value` changes a value before it is checked: `--set swarms.flies.count=10`, `--set swarms.0.count=10`,
`--set world.bounds.max.2=50`, `--set world.obstacles.0.mesh=/data/tree.off`. The value is YAML; elements of a list go by
number, from 0, or by their `name`.

## What YAML may be used
One document in UTF-8, at most 1 MiB, 32 levels deep, 100 000 items. Duplicate keys, anchors, aliases and tags are errors.
)";

std::string range_text(const Key& key) {
  const bool has_range = key.type == KeyType::kInteger || key.type == KeyType::kNumber ||
                         key.type == KeyType::kVector || key.type == KeyType::kComparison;
  if (!has_range) {
    return {};
  }
  const std::string low =
      std::isfinite(key.min) ? fmt::format("{}{:.16g}", key.above_min ? "> " : "", key.min) : "";
  const std::string high = std::isfinite(key.max) ? fmt::format("{:.16g}", key.max) : "";
  return low.empty() && high.empty() ? "" : low + " … " + high;
}

std::string type_text(const Key& key) {
  switch (key.type) {
    case KeyType::kMap:
    case KeyType::kNamedMap:
      return "map";
    case KeyType::kList:
      return "list";
    case KeyType::kText:
      return "text";
    case KeyType::kName:
      return "name";
    case KeyType::kNames:
      return "name, or list of names";
    case KeyType::kFile:
      return "file";
    case KeyType::kInteger:
      return "whole number";
    case KeyType::kNumber:
      return "number";
    case KeyType::kVector:
      return "[x, y, z]";
    case KeyType::kFlag:
      return "on, off";
    case KeyType::kChoice:
      return list_names(key.choices);
    case KeyType::kComparison:
      return "comparison";
  }
  return {};
}

std::string remarks(const Key& key) {
  std::string text = key.text;
  if (!key.later.empty()) {
    text += " Not in this version: " + list_names(key.later) + ".";
  }
  if (!key.needs.empty()) {
    text += fmt::format(" Only beside `{}`.", key.needs);
  }
  return text;
}

std::string row(const Key& key) {
  const std::string fallback = key.fallback.empty() ? key.fallback_text : "`" + key.fallback + "`";
  const char* bold = key.required ? "**" : "";
  return fmt::format("| {0}`{1}`{0} | {2} | {3} | {4} | {5} | {6} |\n", bold, key.path, type_text(key),
                     key.unit, range_text(key), fallback, remarks(key));
}

}  // namespace

std::string scenario_reference_page() {
  constexpr const char* kHead =
      "\n| key | type | unit | range | default | what it is |\n|---|---|---|---|---|---|\n";
  std::string page = kIntroduction;
  page += std::string("\n## The run\n") + kHead;
  for (const Key* key : child_keys("")) {
    page += key->type == KeyType::kMap || key->type == KeyType::kNamedMap || key->type == KeyType::kList
                ? ""
                : row(*key);
  }
  for (const Key* top : child_keys("")) {
    if (top->type != KeyType::kMap && top->type != KeyType::kNamedMap && top->type != KeyType::kList) {
      continue;
    }
    page += fmt::format("\n## {}\n{}", top->path, kHead);
    for (const Key& key : scenario_keys()) {
      const bool is_under = key.path.starts_with(top->path + ".") || key.path.starts_with(top->path + "[]");
      page += is_under || key.path == top->path ? row(key) : "";
    }
  }
  return page;
}

}  // namespace mayfly
