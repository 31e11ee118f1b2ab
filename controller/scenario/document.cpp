#include "controller/scenario/document.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <sstream>
#include <unordered_map>
#include <utility>

#include "controller/scenario/brackets.hpp"

namespace mayfly {
namespace {

// Leaves yaml-cpp's parser early; never leaves this file.
struct Refused {
  Error error;
  bool maybe_slip = false;  // an open bracket can look like this
};

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(YamlMark base, bool has_lines) : base_(std::move(base)), has_lines_(has_lines) {
    root_.mark = base_;
  }

  YamlNode take() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& at) override {
    if (++documents_ > 1) {
      refuse(at, "a second document starts here", "one document a file");
    }
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& at, YAML::anchor_t anchor) override {
    check(at, "", anchor);
    YamlNode node = node_at(at, YamlNode::Kind::kNull);
    // An omitted value is reported at the next token, often lines below: its key is where a reader would
    // look.
    if (!open_.empty() && open_.back().key && node.mark.line != open_.back().key->mark.line) {
      node.mark = open_.back().key->mark;
    }
    add(at, std::move(node));
  }
  void OnAlias(const YAML::Mark& at, YAML::anchor_t) override { refuse_reference(at); }
  void OnScalar(const YAML::Mark& at, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check(at, tag, anchor);
    // Names and paths end up in messages and file names; escapes such as "\e" could otherwise drive a
    // terminal.
    if (std::any_of(value.begin(), value.end(), is_control)) {
      refuse(at, "a text has a line break or a control character in it", "one line of plain text");
    }
    YamlNode node = node_at(at, YamlNode::Kind::kScalar);
    node.text = value;
    node.quoted = tag == "!";  // how yaml-cpp marks a scalar that is not plain
    add(at, std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& at, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(at, tag, anchor, YamlNode::Kind::kSequence);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& at, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(at, tag, anchor, YamlNode::Kind::kMap);
  }
  void OnMapEnd() override { close(); }
  void OnAnchor(const YAML::Mark& at, const std::string&) override { refuse_reference(at); }

  YamlMark mark_at(const YAML::Mark& at) const {
    YamlMark mark = base_;
    if (has_lines_) {
      mark.line = std::max(at.line, 0) + 1;
      mark.column = std::max(at.column, 0) + 1;
    }
    return mark;
  }

 private:
  // A collection whose end has not come yet. `key` waits for its value.
  struct Open {
    YamlNode node;
    std::optional<YamlEntry> key;
    std::unordered_map<std::string, int> lines;  // of the keys so far
  };

  [[noreturn]] void refuse(const YAML::Mark& at, std::string message, std::string wanted) const {
    throw Refused{{.message = std::move(message), .place = mark_at(at).place(), .wanted = std::move(wanted)}};
  }
  [[noreturn]] void refuse_reference(const YAML::Mark& at) const {
    refuse(at, "anchors and aliases (& and *) are not allowed", "the value written out");
  }

  void check(const YAML::Mark& at, const std::string& tag, YAML::anchor_t anchor) {
    if (anchor != 0) {
      refuse_reference(at);
    }
    if (!tag.empty() && tag != "?" && tag != "!") {
      refuse(at, "tags (such as !!int) are not allowed", "a plain value");
    }
    if (++items_ > kMaxYamlItems) {
      refuse(at, "the file has too many items", "at most " + std::to_string(kMaxYamlItems));
    }
  }

  YamlNode node_at(const YAML::Mark& at, YamlNode::Kind kind) const {
    YamlNode node;
    node.kind = kind;
    node.mark = mark_at(at);
    return node;
  }

  void open(const YAML::Mark& at, const std::string& tag, YAML::anchor_t anchor, YamlNode::Kind kind) {
    check(at, tag, anchor);
    if (open_.size() >= static_cast<std::size_t>(kMaxYamlDepth)) {
      refuse(at, "lists and maps are nested too deeply",
             "at most " + std::to_string(kMaxYamlDepth) + " levels");
    }
    if (wants_key()) {
      throw Refused{
          {.message = "a list or a map cannot be a key", .place = mark_at(at).place(), .wanted = "a name"},
          true};
    }
    open_.push_back({node_at(at, kind), std::nullopt, {}});
  }

  void close() {
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    place(std::move(node));
  }

  bool wants_key() const {
    return !open_.empty() && open_.back().node.kind == YamlNode::Kind::kMap && !open_.back().key;
  }

  void add(const YAML::Mark& at, YamlNode node) {
    if (wants_key()) {
      start_key(at, std::move(node));
    } else {
      place(std::move(node));
    }
  }

  void start_key(const YAML::Mark& at, YamlNode node) {
    if (node.kind != YamlNode::Kind::kScalar || node.text.empty()) {
      refuse(at, "a key is empty", "a name before the colon");
    }
    Open& map = open_.back();
    const auto [first, is_new] = map.lines.emplace(node.text, node.mark.line);
    if (!is_new) {
      const YamlEntry* earlier = nullptr;
      for (const YamlEntry& entry : map.node.entries) {
        earlier = entry.key == node.text ? &entry : earlier;
      }
      throw Refused{{.message = "the key '" + node.text + "' is given twice",
                     .place = node.mark.place(),
                     .found = "it first at " + std::to_string(first->second) + ":" +
                              std::to_string(earlier ? earlier->mark.column : 0),
                     .wanted = "each key once"}};
    }
    map.key = YamlEntry{std::move(node.text), std::move(node.mark), {}};
  }

  void place(YamlNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (parent.node.kind == YamlNode::Kind::kSequence) {
      parent.node.items.push_back(std::move(node));
      return;
    }
    parent.key->value = std::move(node);
    parent.node.entries.push_back(std::move(*parent.key));
    parent.key.reset();
  }

  YamlMark base_;
  bool has_lines_;
  int documents_ = 0;
  std::size_t items_ = 0;
  YamlNode root_;
  std::vector<Open> open_;
};

// Length of the well-formed UTF-8 sequence that starts at `i`, or 0.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned lead = byte(i);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || i + length > text.size()) {
    return 0;
  }
  for (std::size_t k = i + 1; k < i + length; ++k) {
    if ((byte(k) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  return length;
}

// yaml-cpp guesses encodings, and takes some control characters for its own end-of-file mark: it gets
// neither.
std::optional<Error> check_bytes(std::string_view text, const YamlMark& base, bool has_lines) {
  const auto refuse = [&](int line, int column, std::string message, std::string wanted) {
    YamlMark mark = base;
    mark.line = has_lines ? line : 0;
    mark.column = has_lines ? column : 0;
    return Error{.message = std::move(message), .place = mark.place(), .wanted = std::move(wanted)};
  };
  if (text.size() > kMaxYamlBytes) {
    return refuse(1, 1, "the file has " + std::to_string(text.size()) + " bytes",
                  "at most " + std::to_string(kMaxYamlBytes));
  }
  int line = 1;
  int column = 1;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const char c = text[i];
    if (length == 0) {
      return refuse(line, column, "this is not UTF-8 text", "a text file in UTF-8");
    }
    if (is_control(c) && c != '\n' && c != '\r' && c != '\t') {
      return refuse(line, column, "a control character (byte " + std::to_string(c) + ")", "a text file");
    }
    column = c == '\n' ? 1 : column + static_cast<int>(length);
    line += c == '\n' ? 1 : 0;
    i += length;
  }
  return std::nullopt;
}

// The parser's own words, unless the reason is one that can be said better.
Error explain(std::string_view text, Error error, const YamlMark& base, bool has_lines) {
  const auto slip = find_yaml_slip(text, error.place && has_lines ? error.place->line : 1);
  if (!slip) {
    return error;
  }
  YamlMark mark = base;
  mark.line = has_lines ? slip->line : 0;
  mark.column = has_lines ? slip->column : 0;
  return {.message = slip->message, .place = mark.place(), .wanted = slip->wanted};
}

Result<YamlNode> parse(std::string_view text, const YamlMark& base, bool has_lines) {
  if (auto error = check_bytes(text, base, has_lines)) {
    return fail(std::move(*error));
  }
  TreeBuilder builder(base, has_lines);
  try {
    std::istringstream stream{std::string(text)};
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (Refused& refused) {
    return fail(refused.maybe_slip ? explain(text, std::move(refused.error), base, has_lines)
                                   : std::move(refused.error));
  } catch (const YAML::Exception& problem) {
    Error error{.message = "this is not valid YAML: " + problem.msg,
                .place = builder.mark_at(problem.mark).place()};
    return fail(explain(text, std::move(error), base, has_lines));
  } catch (const std::exception& problem) {
    return fail({.message = std::string("this is not valid YAML: ") + problem.what(), .place = base.place()});
  }
  return builder.take();
}

auto find_value(auto& entries, std::string_view key) -> decltype(&entries.front().value) {
  const auto it = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.key == key; });
  return it == entries.end() ? nullptr : &it->value;
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
  return find_value(entries, key);
}

YamlNode* YamlNode::find(std::string_view key) {
  return find_value(entries, key);
}

Result<YamlNode> parse_yaml(std::string_view text, const std::string& file) {
  return parse(text, YamlMark{std::make_shared<const std::string>(file), 1, 1}, true);
}

Result<YamlNode> parse_yaml_value(std::string_view text, const YamlMark& mark) {
  return parse(text, mark, false);
}

std::string describe(const YamlNode& node) {
  constexpr std::size_t kLongest = 60;
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      return "nothing";
    case YamlNode::Kind::kScalar:
      return node.text.size() <= kLongest ? "'" + node.text + "'"
                                          : "'" + node.text.substr(0, kLongest) + "…'";
    case YamlNode::Kind::kSequence:
      return "a list of " + std::to_string(node.items.size());
    case YamlNode::Kind::kMap:
      return "a map of " + std::to_string(node.entries.size());
  }
  return {};
}

}  // namespace mayfly
