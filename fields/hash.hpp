// Names for content: equal bytes, equal name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace mayfly::fields {

// XXH64, after its published specification (Collet, xxHash fast digest algorithm): fast, well mixed, not
// cryptographic.
std::uint64_t hash64(std::span<const std::byte> bytes, std::uint64_t seed = 0) noexcept;

// Collects what a result depends on, value by value (never whole structs: padding), and names it.
class ContentHash {
 public:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T> ContentHash& add(const T& value) {
    return add_bytes(std::as_bytes(std::span<const T, 1>(&value, 1)));
  }
  ContentHash& add(std::string_view text) {
    add(text.size());
    return add_bytes(std::as_bytes(std::span<const char>(text.data(), text.size())));
  }
  // Arrays of numbers (or of glm vectors, which have no padding); the count is part of the content.
  template <class T>
  ContentHash& add_all(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(values.size());
    return add_bytes(std::as_bytes(values));
  }
  // 32 hex digits: two XXH64 of different seeds, so that a clash of two worlds is out of question.
  std::string hex() const;

 private:
  ContentHash& add_bytes(std::span<const std::byte> bytes) {
    bytes_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return *this;
  }

  std::string bytes_;
};

}  // namespace mayfly::fields
