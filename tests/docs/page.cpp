#include "tests/docs/page.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace mayfly::test {
namespace {

constexpr std::string_view kAnything = "…";

void add_links(const std::string& line, std::vector<std::string>& links) {
  static const std::regex kLink(R"(\]\(([^)#\s]*)(#[^)]*)?\))");
  for (std::sregex_iterator match(line.begin(), line.end(), kLink), end; match != end; ++match) {
    const std::string target = (*match)[1];
    if (!target.empty() && target.find("://") == std::string::npos) {
      links.push_back(target);
    }
  }
}

bool line_shows(const std::string& line, const std::string& wanted) {
  std::size_t at = 0;
  std::size_t from = 0;
  while (from <= wanted.size()) {
    const std::size_t to = std::min(wanted.find(kAnything, from), wanted.size());
    at = line.find(wanted.substr(from, to - from), at);
    if (at == std::string::npos) {
      return false;
    }
    at += to - from;
    from = to + kAnything.size();
  }
  return true;
}

}  // namespace

bool Block::has(const std::string& word) const {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string Block::value(const std::string& key) const {
  for (const std::string& word : words) {
    if (word.rfind(key + '=', 0) == 0) {
      return word.substr(key.size() + 1);
    }
  }
  return {};
}

Page read_page(const std::filesystem::path& file) {
  Page page;
  page.file = file;
  std::ifstream in(file);
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.rfind("```", 0) == 0) {
      inside = !inside;
      if (inside) {
        std::istringstream info(line.substr(3));
        Block block;
        block.line = number;
        for (std::string word; info >> word;) {
          block.words.push_back(word);
        }
        page.blocks.push_back(block);
      }
    } else if (inside) {
      page.blocks.back().text += line + '\n';
    } else {
      add_links(line, page.links);
    }
  }
  return page;
}

std::vector<std::filesystem::path> all_pages(const std::filesystem::path& top) {
  std::vector<std::filesystem::path> pages{top / "README.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(top / "docs")) {
    if (entry.path().extension() == ".md") {
      pages.push_back(entry.path());
    }
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

bool shows(const std::string& output, const std::string& wanted) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line_shows(line, wanted)) {
      return true;
    }
  }
  return false;
}

}  // namespace mayfly::test
