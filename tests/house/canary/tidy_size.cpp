// bites: [readability-function-size,-warnings-as-errors]
namespace mayfly {
int many(int a, int b, int c, int d, int e, int f, int g, int h) { return a + b + c + d + e + f + g + h; }
}  // namespace mayfly
