// bites: shadow
namespace mayfly {
int outer(int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i) {
    const int n = i;
    sum += n;
  }
  return sum;
}
}  // namespace mayfly
