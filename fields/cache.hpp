// Fields that were computed before, kept on disk by content.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace mayfly::fields {

// Arrays of floats in a folder, by default the user's (core/cache_directory.hpp), one file each. The file's
// name is a hash of the key; the whole key and an XXH64 of the payload stand in its header, so neither a
// clash nor a damaged file is ever taken for the answer. Writing goes to a temporary file that is renamed:
// two programs may share the folder. Every failure means "compute it": load() answers nothing, store() gives
// up silently.
class FieldCache {
 public:
  FieldCache();
  // Knows nothing and keeps nothing.
  static FieldCache none() { return FieldCache(std::filesystem::path()); }
  explicit FieldCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // The array stored under `key`, if there is one of exactly `expected_count` numbers.
  std::optional<std::vector<float>> load(std::string_view key, std::size_t expected_count) const noexcept;
  void store(std::string_view key, std::span<const float> values) const noexcept;

  std::filesystem::path file_of(std::string_view key) const;

 private:
  std::filesystem::path folder_;  // empty: no place is known, nothing is kept
};

}  // namespace mayfly::fields
