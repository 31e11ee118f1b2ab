// Ticks to record, and a place to record them.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "controller/flight/observer.hpp"

namespace mayfly::test {

class Frames {
 public:
  explicit Frames(std::size_t agents)
      : numbers(9, std::vector<float>(agents)), kinds(agents, CommandKind::kVelocity), valid(agents, 1) {}
  TickView at(std::uint64_t tick) const {
    return {tick,       std::chrono::milliseconds(10) * static_cast<Time::rep>(tick),
            numbers[0], numbers[1],
            numbers[2], numbers[3],
            numbers[4], numbers[5],
            numbers[6], numbers[7],
            numbers[8], kinds,
            valid};
  }

  std::vector<std::vector<float>> numbers;
  std::vector<CommandKind> kinds;
  std::vector<std::uint8_t> valid;
};

class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "mayfly-record-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("no temporary folder");
    }
    path = pattern;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }
  bool empty() const { return std::filesystem::is_empty(path); }

  std::filesystem::path path;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace mayfly::test
