#include "controller/scenario/preset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "builtin_presets.inc"
#include "controller/scenario/check.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

namespace fs = std::filesystem;
using Kind = YamlNode::Kind;

// Parts of letters, digits and _ between slashes: nothing that can climb.
bool is_preset_name(std::string_view name) {
  bool after_slash = true;
  for (const unsigned char c : name) {
    const bool is_word =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (!is_word && (c != '/' || after_slash)) {
      return false;
    }
    after_slash = c == '/';
  }
  return !after_slash;
}

void drop(YamlNode& map, std::string_view key) {
  std::erase_if(map.entries, [&](const YamlEntry& entry) { return entry.key == key; });
}

// Octaves, and scale with gain, say the same thing in two ways: the swarm's own way must win whole.
void drop_overruled_noise(YamlNode& preset, const YamlNode& own) {
  if (own.find("octaves") != nullptr) {
    drop(preset, "scale");
    drop(preset, "gain");
  }
  if (own.find("scale") != nullptr || own.find("gain") != nullptr) {
    drop(preset, "octaves");
  }
}

void put_under(YamlNode& own, YamlNode preset) {
  drop_overruled_noise(preset, own);
  for (YamlEntry& entry : preset.entries) {
    YamlNode* value = own.find(entry.key);
    if (value == nullptr) {
      own.entries.push_back(std::move(entry));
    } else if (value->kind == Kind::kMap && entry.value.kind == Kind::kMap) {
      put_under(*value, std::move(entry.value));
    }
  }
}

class Presets {
 public:
  explicit Presets(const FileRoots& roots) : roots_(roots) {}

  Result<YamlNode> load(const YamlNode& name) {
    const auto known = loaded_.find(name.text);
    if (known != loaded_.end()) {
      return known->second;
    }
    auto tree = parse_named(name);
    if (!tree) {
      return tree;
    }
    if (auto problem = check(*tree)) {
      return fail(std::move(*problem));
    }
    return loaded_.emplace(name.text, std::move(*tree)).first->second;
  }

 private:
  Result<YamlNode> parse_named(const YamlNode& name) const {
    const fs::path file = project_file(name.text);
    if (!file.empty()) {
      const auto text = read_text_file(file);
      return text ? parse_yaml(*text, file.string()) : fail(text.error());
    }
    const auto built_in = builtin_presets().find(name.text);
    if (built_in != builtin_presets().end()) {
      return parse_yaml(built_in->second, "config/presets/" + name.text + ".yaml");
    }
    std::vector<std::string> names;
    for (const auto& [known, text] : builtin_presets()) {
      names.push_back(known);
    }
    return fail({.message = "there is no such preset",
                 .place = name.mark.place(),
                 .found = describe(name),
                 .wanted = "a file of config/presets without its ending, such as " + list_names(names),
                 .suggestion = nearest_name(name.text, names)});
  }

  fs::path project_file(const std::string& name) const {
    if (roots_.project.empty() || !is_preset_name(name)) {
      return {};
    }
    std::error_code problem;
    const fs::path file =
        fs::weakly_canonical(roots_.project / "config" / "presets" / (name + ".yaml"), problem);
    return !problem && roots_.contain(file) && fs::is_regular_file(file, problem) ? file : fs::path();
  }

  static std::optional<Error> check(const YamlNode& tree) {
    if (tree.kind != Kind::kMap) {
      return Error{.message = "a preset is a map of a swarm's keys",
                   .place = tree.mark.place(),
                   .found = describe(tree)};
    }
    for (const char* key : {"name", "preset"}) {
      if (const YamlNode* value = tree.find(key)) {
        return Error{.message = fmt::format("a preset cannot give '{}'", key), .place = value->mark.place()};
      }
    }
    return std::nullopt;
  }

  const FileRoots& roots_;
  std::map<std::string, YamlNode> loaded_;
};

}  // namespace

std::vector<Error> apply_presets(YamlNode& root, const FileRoots& roots) {
  std::vector<Error> errors;
  Presets presets(roots);
  YamlNode* swarms = root.find("swarms");
  if (swarms == nullptr) {
    return errors;
  }
  for (YamlNode& swarm : swarms->items) {
    const YamlNode* name = swarm.find("preset");
    // Anything else than a text is left for the checks to refuse.
    if (name == nullptr || name->kind != Kind::kScalar || errors.size() >= kMaxErrors) {
      continue;
    }
    auto preset = presets.load(*name);
    if (preset) {
      put_under(swarm, std::move(*preset));
    } else {
      errors.push_back(std::move(preset.error()));
    }
  }
  return errors;
}

const std::map<std::string, std::string>& builtin_presets() {
  static const std::map<std::string, std::string> kPresets(std::begin(kBuiltinPresets),
                                                           std::end(kBuiltinPresets));
  return kPresets;
}

}  // namespace mayfly
