// bites: [performance-for-range-copy,-warnings-as-errors]
#include <cstddef>
#include <string>
#include <vector>

namespace mayfly {
std::size_t letters(const std::vector<std::string>& words) {
  std::size_t sum = 0;
  for (const std::string word : words) {
    sum += word.size();
  }
  return sum;
}
}  // namespace mayfly
