// bites: [readability-function-cognitive-complexity,-warnings-as-errors]
namespace mayfly {
int maze(int n) {
  int steps = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      if (i % 2 == 0) {
        if (j % 2 == 0) {
          ++steps;
        }
        if (j % 3 == 0) {
          ++steps;
        }
        if (j % 5 == 0) {
          ++steps;
        }
        if (j % 7 == 0) {
          ++steps;
        }
        if (j % 11 == 0) {
          ++steps;
        }
      }
    }
  }
  return steps;
}
}  // namespace mayfly
