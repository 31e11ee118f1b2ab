#include "tests/house/include_directions.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace mayfly::house {
namespace {

using Rooms = std::set<std::string, std::less<>>;

// Written out in full rather than followed from room to room: what stands here is the whole rule.
const std::map<std::string, Rooms, std::less<>>& allowed() {
  static const std::map<std::string, Rooms, std::less<>> kTable = {
      {"core", {"core"}},
      {"kernels", {"kernels", "core"}},
      {"compute", {"compute", "kernels", "core"}},
      {"fields", {"fields", "kernels", "core"}},
      {"controller", {"controller", "fields", "compute", "kernels", "core"}},
      {"drivers", {"drivers", "core"}},
      {"sim_hal", {"sim_hal", "compute", "drivers", "kernels", "core"}},
      {"simulate", {"simulate", "controller", "sim_hal", "fields", "compute", "drivers", "kernels", "core"}},
      {"record", {"record", "controller", "fields", "compute", "kernels", "core"}},
      {"analysis", {"analysis", "controller", "fields", "compute", "kernels", "core"}},
  };
  return kTable;
}

// At the edge of the tree: they may use every room that has a rule above, and their own files; may_look()
// says what else.
constexpr std::array<std::string_view, 4> kEverything = {"app", "examples", "tests", "bench"};

bool is_source(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".cpp" || ending == ".hpp" || ending == ".h" || ending == ".cl";
}

bool sees_everything(std::string_view room) {
  return std::find(kEverything.begin(), kEverything.end(), room) != kEverything.end();
}

bool may_look(const std::string& from, const std::string& to) {
  const auto rule = allowed().find(from);
  if (rule != allowed().end()) {
    return rule->second.contains(to);
  }
  // `mayfly bench` runs what stands in bench/, and tests look everywhere.
  const bool across = (from == "app" && to == "bench") || (from == "tests" && sees_everything(to));
  return sees_everything(from) && (from == to || allowed().contains(to) || across);
}

struct Include {
  std::string target;
  bool quoted = false;
};

std::string_view skip_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

// `  #  include "a/b.hpp"` or `#include <a>`; nothing for any other line.
std::optional<Include> parse_include(std::string_view line) {
  constexpr std::string_view kWord = "include";
  line = skip_blanks(line);
  if (!line.starts_with('#')) {
    return std::nullopt;
  }
  line = skip_blanks(line.substr(1));
  if (!line.starts_with(kWord)) {
    return std::nullopt;
  }
  line = skip_blanks(line.substr(kWord.size()));
  if (!line.starts_with('"') && !line.starts_with('<')) {
    return std::nullopt;
  }
  const bool quoted = line.front() == '"';
  const auto end = line.find(quoted ? '"' : '>', 1);
  return Include{std::string(line.substr(1, end - 1)), quoted};
}

// What is wrong with it; empty where nothing is.
std::string fault(const std::filesystem::path& top, const std::string& room, const Include& include) {
  const std::string to = include.target.substr(0, include.target.find('/'));
  const bool ours = allowed().contains(to) || sees_everything(to);
  if (!include.quoted && !(ours && std::filesystem::exists(top / include.target))) {
    return {};  // a library's header
  }
  if (include.quoted && include.target.ends_with(".inc") && include.target.find('/') == std::string::npos) {
    return {};  // generated into the build tree by the folder's own CMakeLists.txt
  }
  if (!include.quoted || !ours || include.target.find("..") != std::string::npos) {
    return "'" + include.target + "' does not start at the top of the tree, in quotes, with a known folder";
  }
  if (!may_look(room, to)) {
    return room + "/ may not look into " + to + "/ ('" + include.target + "')";
  }
  return {};
}

void check_file(const std::filesystem::path& top, const std::filesystem::path& file,
                std::vector<std::string>& wrong) {
  const std::filesystem::path path = file.lexically_relative(top);
  const std::string room = path.begin()->string();
  std::ifstream in(file);
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    const auto include = parse_include(text);
    const std::string what = include ? fault(top, room, *include) : std::string();
    if (!what.empty()) {
      wrong.push_back(path.string() + ":" + std::to_string(line) + ": " + what);
    }
  }
}

}  // namespace

std::vector<std::string> wrong_includes(const std::filesystem::path& top) {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> wrong;
  for (const auto& folder : std::filesystem::directory_iterator(top)) {
    const std::string room = folder.path().filename().string();
    if (!folder.is_directory() || (!allowed().contains(room) && !sees_everything(room))) {
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
      const std::string path = entry.path().lexically_relative(top).generic_string();
      const bool bait = path.starts_with("tests/house/canary") || path.starts_with("tests/house/fixtures");
      if (entry.is_regular_file() && is_source(entry.path()) && !bait) {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    check_file(top, file, wrong);
  }
  return wrong;
}

}  // namespace mayfly::house
