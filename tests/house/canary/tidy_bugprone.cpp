// bites: [bugprone-use-after-move,-warnings-as-errors]
#include <string>
#include <utility>

namespace mayfly {
std::string twice(std::string text) {
  std::string taken = std::move(text);
  return taken + text;
}
}  // namespace mayfly
