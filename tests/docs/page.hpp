// A page of the documentation, as its test sees it: fenced blocks and links.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mayfly::test {

// ```sh run exit=1 needs=config/meshes/elephant.off
struct Block {
  int line = 0;                    // of the opening fence, from 1
  std::vector<std::string> words;  // of its info string: "sh", "run", "exit=1", …
  std::string text;

  bool is(const std::string& language) const { return !words.empty() && words.front() == language; }
  bool has(const std::string& word) const;
  // What follows "key="; empty where it is not there.
  std::string value(const std::string& key) const;
};

struct Page {
  std::filesystem::path file;
  std::vector<Block> blocks;
  std::vector<std::string> links;  // targets as written, fragments cut off; web addresses left out
};

Page read_page(const std::filesystem::path& file);

// README.md and all of docs/, by name.
std::vector<std::filesystem::path> all_pages(const std::filesystem::path& top);

// Whether one line of `output` contains `wanted`, in which "…" stands for anything.
bool shows(const std::string& output, const std::string& wanted);

}  // namespace mayfly::test
