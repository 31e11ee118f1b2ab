// bites: [readability-identifier-naming,-warnings-as-errors]
namespace mayfly {
struct wrong_case {
  int value = 0;
};
int use() { return wrong_case{}.value; }
}  // namespace mayfly
