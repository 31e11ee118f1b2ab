#include "fields/cache.hpp"

#include <unistd.h>

#include <atomic>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "core/cache_directory.hpp"
#include "fields/hash.hpp"

namespace mayfly::fields {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kMagic = 0x4359414D;  // "MAYC"
constexpr std::uint32_t kVersion = 1;

struct Header {
  std::uint32_t magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint64_t key_bytes = 0;
  std::uint64_t count = 0;
  std::uint64_t checksum = 0;
};
static_assert(sizeof(Header) == 32);

std::uint64_t checksum(std::span<const float> values) noexcept {
  return hash64(std::as_bytes(values));
}

std::optional<std::vector<float>> read_file(const fs::path& file, std::string_view key,
                                            std::size_t expected_count) {
  std::ifstream in(file, std::ios::binary);
  Header header;
  if (!in.read(reinterpret_cast<char*>(&header), sizeof header) || header.magic != kMagic ||
      header.version != kVersion || header.key_bytes != key.size() || header.count != expected_count ||
      fs::file_size(file) != sizeof header + key.size() + expected_count * sizeof(float)) {
    return std::nullopt;
  }
  std::string stored_key(key.size(), '\0');
  std::vector<float> values(expected_count);
  if (!in.read(stored_key.data(), static_cast<std::streamsize>(key.size())) || stored_key != key ||
      !in.read(reinterpret_cast<char*>(values.data()),
               static_cast<std::streamsize>(expected_count * sizeof(float))) ||
      checksum(values) != header.checksum) {
    return std::nullopt;
  }
  return values;
}

bool write_file(const fs::path& file, std::string_view key, std::span<const float> values) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  const Header header{kMagic, kVersion, key.size(), values.size(), checksum(values)};
  out.write(reinterpret_cast<const char*>(&header), sizeof header);
  out.write(key.data(), static_cast<std::streamsize>(key.size()));
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
  out.close();
  return !out.fail();
}

// No two writers, in this process or another, may share a temporary file.
fs::path temporary_beside(const fs::path& file) {
  static std::atomic<unsigned> count{0};
  return file.string() + "." + std::to_string(::getpid()) + "." + std::to_string(count.fetch_add(1)) + ".tmp";
}

}  // namespace

FieldCache::FieldCache() : folder_(cache_directory().value_or(fs::path{})) {}

fs::path FieldCache::file_of(std::string_view key) const {
  return folder_ / (ContentHash{}.add(key).hex() + ".field");
}

std::optional<std::vector<float>> FieldCache::load(std::string_view key,
                                                   std::size_t expected_count) const noexcept {
  try {
    if (folder_.empty()) {
      return std::nullopt;
    }
    const fs::path file = file_of(key);
    // A device or pipe of that name would block or never end.
    return fs::is_regular_file(file) ? read_file(file, key, expected_count) : std::nullopt;
  } catch (...) {
    return std::nullopt;
  }
}

void FieldCache::store(std::string_view key, std::span<const float> values) const noexcept {
  try {
    if (folder_.empty()) {
      return;
    }
    fs::create_directories(folder_);
    const fs::path file = file_of(key);
    const fs::path temporary = temporary_beside(file);
    std::error_code ignored;
    if (write_file(temporary, key, values)) {
      fs::rename(temporary, file, ignored);
    }
    fs::remove(temporary, ignored);
  } catch (...) {
    // The folder is full, read-only or gone: the next run computes again.
  }
}

}  // namespace mayfly::fields
