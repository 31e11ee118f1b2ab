// Compiled programs on disk. Nothing here can fail in a way that matters: what is not usable is not there.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mayfly::compute {

using Binary = std::vector<unsigned char>;

enum class Lookup { kFound, kMissing, kRejected };

struct CachedBinary {
  Lookup lookup = Lookup::kMissing;
  Binary binary;
};

// `key` is the whole of what the binary depends on, not a hash of it: it is stored beside the binary and
// compared.
CachedBinary load_binary(std::string_view key) noexcept;
// False where it could not be written, e.g. because there is no cache folder.
bool store_binary(std::string_view key, const Binary& binary) noexcept;

}  // namespace mayfly::compute
