#include "tests/house/include_directions.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <regex>
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
      {"record", {"record", "controller", "fields", "compute", "kernels", "core"}},
      {"analysis", {"analysis", "controller", "fields", "compute", "kernels", "core"}},
  };
  return kTable;
}

// At the edge of the tree: they may use every room that has a rule above, and their own files.
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
  return sees_everything(from) && (from == to || allowed().contains(to) || (from == "tests" && to == "app"));
}

void check_file(const std::filesystem::path& top, const std::filesystem::path& file, const std::string& room,
                std::vector<std::string>& wrong) {
  static const std::regex kPattern(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
  std::ifstream in(file);
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    std::smatch match;
    if (!std::regex_search(text, match, kPattern)) {
      continue;
    }
    const std::string target = match[2];
    const std::string to = target.substr(0, target.find('/'));
    const bool quoted = match[1] == "\"";
    const bool ours = allowed().contains(to) || sees_everything(to);
    if (!quoted && !(ours && std::filesystem::exists(top / target))) {
      continue;  // a library's header
    }
    const std::string place = file.lexically_relative(top).string() + ":" + std::to_string(line) + ": ";
    if (!quoted || !ours || target.find("..") != std::string::npos) {
      wrong.push_back(place + "'" + target +
                      "' does not start at the top of the tree, in quotes, with a known folder");
    } else if (!may_look(room, to)) {
      wrong.push_back(place + room + "/ may not look into " + to + "/ ('" + target + "')");
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
    check_file(top, file, file.lexically_relative(top).begin()->string(), wrong);
  }
  return wrong;
}

}  // namespace mayfly::house
