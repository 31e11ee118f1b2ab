// bites: [concurrency-mt-unsafe,-warnings-as-errors]
#include <ctime>

namespace mayfly {
int hour(std::time_t time) { return std::localtime(&time)->tm_hour; }
}  // namespace mayfly
