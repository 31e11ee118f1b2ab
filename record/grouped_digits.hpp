// Large numbers that can be read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mayfly::record {

// "268 800", with whatever separator between each three digits.
inline std::string grouped_digits(std::uint64_t number, std::string_view separator) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) {
      text.append(separator);
    }
    text.push_back(digits[i]);
  }
  return text;
}

}  // namespace mayfly::record
