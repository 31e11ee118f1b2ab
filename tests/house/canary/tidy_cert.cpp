// bites: [cert-err34-c,-warnings-as-errors]
#include <cstdlib>

namespace mayfly {
int parse(const char* text) { return std::atoi(text); }
}  // namespace mayfly
