// bites: [modernize-use-nullptr,-warnings-as-errors]
namespace mayfly {
const int* nothing() { return 0; }
}  // namespace mayfly
