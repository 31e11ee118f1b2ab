// bites: [cppcoreguidelines-pro-type-member-init,-warnings-as-errors]
namespace mayfly {
class Sample {
 public:
  Sample() {}
  int value() const { return value_; }

 private:
  int value_;
};
int use() { return Sample{}.value(); }
}  // namespace mayfly
