#include "controller/scenario/files.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <vector>

#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

namespace fs = std::filesystem;

fs::path canonical_or_empty(const fs::path& path) {
  std::error_code problem;
  fs::path result = fs::weakly_canonical(fs::absolute(path, problem), problem);
  return problem ? fs::path() : result;
}

bool is_under(const fs::path& path, const fs::path& root) {
  return !root.empty() &&
         std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

bool is_project(const fs::path& folder) {
  std::error_code problem;
  return fs::exists(folder / "mayfly.project", problem) || fs::exists(folder / ".git", problem);
}

// What is wrong with a path that should be a regular file; empty if nothing is.
std::string file_problem(const fs::path& file) {
  std::error_code problem;
  const fs::file_status status = fs::status(file, problem);
  switch (status.type()) {
    case fs::file_type::regular:
      return {};
    case fs::file_type::not_found:
      return "there is no such file";
    case fs::file_type::directory:
      return "this is a folder, not a file";
    case fs::file_type::none:
    case fs::file_type::unknown:
      return "this file cannot be looked at (" + problem.message() + ")";
    default:
      return "this is a device, a pipe or a socket, not a file";
  }
}

}  // namespace

bool FileRoots::contain(const fs::path& canonical) const {
  return is_under(canonical, scenario) || is_under(canonical, project);
}

FileRoots find_roots(const fs::path& scenario_file) {
  FileRoots roots;
  roots.scenario = canonical_or_empty(canonical_or_empty(scenario_file).parent_path());
  for (fs::path folder = roots.scenario; folder.has_relative_path(); folder = folder.parent_path()) {
    if (is_project(folder)) {
      roots.project = folder;
      break;
    }
  }
  return roots;
}

Result<fs::path> resolve_file(const YamlNode& node, const FileRoots& roots) {
  const auto refuse = [&](std::string message, std::string wanted, std::string suggestion = {}) {
    return fail({.message = std::move(message),
                 .place = node.mark.place(),
                 .found = describe(node),
                 .wanted = std::move(wanted),
                 .suggestion = std::move(suggestion)});
  };
  const fs::path written(node.text);
  const bool anywhere = written.is_absolute() && node.mark.command_line;
  if (written.is_absolute() && !anywhere) {
    return refuse("an absolute path may only be given on the command line, with --set",
                  "a path relative to the scenario");
  }
  const fs::path file = canonical_or_empty(roots.scenario / written);
  if (file.empty()) {
    return refuse("this path cannot be followed", "the path of a file");
  }
  if (!anywhere && !roots.contain(file)) {
    return refuse("this path leaves the project",
                  "a file under " + (roots.project.empty() ? roots.scenario : roots.project).string());
  }
  if (const std::string problem = file_problem(file); !problem.empty()) {
    std::error_code ignored;
    const std::string near = fs::exists(file, ignored) ? "" : near_file_name(file);
    return refuse(problem, "a file", near.empty() ? "" : (written.parent_path() / near).string());
  }
  return file;
}

Result<std::string> read_text_file(const fs::path& file) {
  const auto refuse = [&](std::string message, std::string suggestion = {}) {
    return fail({.message = std::move(message),
                 .place = Place{file.string(), 0, 0},
                 .suggestion = std::move(suggestion)});
  };
  if (const std::string problem = file_problem(file); !problem.empty()) {
    const std::string near = near_file_name(file);
    return refuse(problem, near.empty() ? "" : (file.parent_path() / near).string());
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text(kMaxYamlBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || (!stream && !stream.eof())) {
    return refuse("this file cannot be read");
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kMaxYamlBytes) {
    return refuse("this file is too large to be a scenario; wanted at most " + std::to_string(kMaxYamlBytes) +
                  " bytes");
  }
  return text;
}

std::string near_file_name(const fs::path& file) {
  constexpr std::size_t kMostNames = 10'000;
  std::error_code problem;
  std::vector<std::string> names;
  for (fs::directory_iterator it(file.parent_path(), problem), end; !problem && it != end;
       it.increment(problem)) {
    names.push_back(it->path().filename().string());
    if (names.size() == kMostNames) {
      break;
    }
  }
  std::sort(names.begin(), names.end());
  return nearest_name(file.filename().string(), names);
}

}  // namespace mayfly
