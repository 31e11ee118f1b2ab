// YAML text as a small tree in which every key and value knows its place, so that errors can point at it.
//
// This is deliberately less than YAML: duplicate keys, anchors, aliases, tags, complex keys and several
// documents are refused, and size, depth and number of items are capped while parsing, so that no file can be
// a bomb.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"

namespace mayfly {

inline constexpr std::size_t kMaxYamlBytes = 1U << 20U;
inline constexpr int kMaxYamlDepth = 32;
inline constexpr std::size_t kMaxYamlItems = 100'000;

// A Place whose file name is shared by every node of a file. Lines and columns count from 1 (columns in
// bytes); 0 where the text has none, as on a command line.
struct YamlMark {
  std::shared_ptr<const std::string> file;
  int line = 0;
  int column = 0;
  bool command_line = false;  // written on the command line, by the person who runs the program

  Place place() const { return {file ? *file : std::string{}, line, column}; }
};

struct YamlEntry;

struct YamlNode {
  enum class Kind { kNull, kScalar, kSequence, kMap };

  Kind kind = Kind::kNull;
  YamlMark mark;
  std::string text;                // kScalar
  bool quoted = false;             // kScalar: "3" is a text, 3 is a number
  std::vector<YamlNode> items;     // kSequence
  std::vector<YamlEntry> entries;  // kMap, in the file's order, keys unique

  // The value of `key`, or null. Defined for every kind: only maps have any.
  const YamlNode* find(std::string_view key) const;
  YamlNode* find(std::string_view key);
};

struct YamlEntry {
  std::string key;
  YamlMark mark;  // of the key
  YamlNode value;
};

// The tree of one document; an empty text is a null node. `file` is what errors call it.
Result<YamlNode> parse_yaml(std::string_view text, const std::string& file);

// The same for a value typed after `--set`: every mark is `mark`.
Result<YamlNode> parse_yaml_value(std::string_view text, const YamlMark& mark);

// What a person would call the node in a message: "the text 'abc'", "a list of 3", "nothing".
std::string describe(const YamlNode& node);

}  // namespace mayfly
