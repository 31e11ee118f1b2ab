#include "controller/scenario/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace mayfly {
namespace {

// Names are short; what is longer than this is not a misspelt name, and quadratic work on it would be a gift
// to bombs.
constexpr std::size_t kLongestName = 64;

std::string folded(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    last[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::string nearest_name(std::string_view typed, std::span<const std::string> names) {
  if (typed.size() > kLongestName) {
    return {};
  }
  const std::string word = folded(typed);
  std::string nearest;
  std::size_t best = std::max<std::size_t>(1, (word.size() + 2) / 3) + 1;
  for (const std::string& name : names) {
    const std::size_t distance = name.size() > kLongestName ? best : edit_distance(word, folded(name));
    if (distance < best && distance < name.size()) {
      best = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::string list_names(std::span<const std::string> names) {
  constexpr std::size_t kMost = 16;
  const std::size_t shown = std::min(names.size(), kMost);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == shown && shown == names.size();
    text += i == 0 ? "" : is_last ? " or " : ", ";
    text += names[i];
  }
  return shown < names.size() ? text + ", …" : text;
}

}  // namespace mayfly
