// Writes the JSON schema and the reference page of scenarios into a source tree.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "controller/scenario/schema_export.hpp"

namespace {

bool write(const std::filesystem::path& file, const std::string& text) {
  std::error_code problem;
  std::filesystem::create_directories(file.parent_path(), problem);
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) {
    std::fprintf(stderr, "cannot write %s\n", file.c_str());
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: mayfly_schema_gen TOP_OF_THE_TREE\n");
    return 2;
  }
  const std::filesystem::path top(argv[1]);
  const bool ok = write(top / "config/scenario.schema.json", mayfly::scenario_json_schema()) &&
                  write(top / "docs/reference/scenario.md", mayfly::scenario_reference_page());
  return ok ? 0 : 1;
}
