#include "compute/program_cache.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/cache_directory.hpp"

namespace mayfly::compute {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "mayfly-program-1";

// FNV-1a: it names files and finds damage; it need not resist an attacker.
std::uint64_t checksum(std::string_view text) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  return hash;
}

std::optional<fs::path> file_of(std::string_view key) {
  const auto folder = cache_directory();
  if (!folder) {
    return std::nullopt;
  }
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%016llx.bin", static_cast<unsigned long long>(checksum(key)));
  return *folder / "programs" / name.data();
}

std::string bytes_of(std::uint64_t number) {
  std::string bytes(sizeof number, '\0');
  for (char& byte : bytes) {
    byte = static_cast<char>(number & 0xffU);
    number >>= 8U;
  }
  return bytes;
}

// magic, length of the key, key, binary, checksum of all before.
std::string head_of(std::string_view key) {
  return std::string(kMagic) + bytes_of(key.size()) + std::string(key);
}

CachedBinary load(std::string_view key) {
  const auto file = file_of(key);
  if (!file || !fs::exists(*file)) {
    return {};
  }
  std::ifstream stream(*file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::string head = head_of(key);
  constexpr std::size_t kTail = sizeof(std::uint64_t);
  if (!content.starts_with(head) || content.size() <= head.size() + kTail) {
    return {Lookup::kRejected, {}};
  }
  const std::string_view sealed = std::string_view(content).substr(0, content.size() - kTail);
  if (!content.ends_with(bytes_of(checksum(sealed)))) {
    return {Lookup::kRejected, {}};
  }
  const std::string_view body = sealed.substr(head.size());
  return {Lookup::kFound, Binary(body.begin(), body.end())};
}

bool store(std::string_view key, const Binary& binary) {
  const auto file = file_of(key);
  if (!file) {
    return false;
  }
  std::error_code error;
  fs::create_directories(file->parent_path(), error);
  // A name of its own for each writer: two processes may build the same program at once, and the last rename
  // wins.
  static std::atomic<unsigned> writers{0};
  fs::path temporary = *file;
  temporary += '.' + std::to_string(::getpid()) + '.' + std::to_string(writers++);
  std::string content = head_of(key);
  content.append(binary.begin(), binary.end());
  content += bytes_of(checksum(content));
  std::ofstream stream(temporary, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (stream) {
    fs::rename(temporary, *file, error);
    if (!error) {
      return true;
    }
  }
  fs::remove(temporary, error);
  return false;
}

}  // namespace

CachedBinary load_binary(std::string_view key) noexcept {
  try {
    return load(key);
  } catch (const std::exception&) {  // out of memory, or a path that the system cannot express
    return {Lookup::kRejected, {}};
  }
}

bool store_binary(std::string_view key, const Binary& binary) noexcept {
  try {
    return store(key, binary);
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace mayfly::compute
