// bites: [misc-unused-parameters,-warnings-as-errors]
namespace mayfly {
int first(int a, int b) { return a; }
}  // namespace mayfly
