// bites: [google-explicit-constructor,-warnings-as-errors]
namespace mayfly {
struct Metres {
  Metres(double value) : value(value) {}
  double value;
};
double use() { return Metres{1.0}.value; }
}  // namespace mayfly
