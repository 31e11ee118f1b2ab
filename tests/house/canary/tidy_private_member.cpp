// bites: invalid case style for private member 'count'
namespace mayfly {
class Counter {
 public:
  int next() { return ++count; }

 private:
  int count = 0;
};
int use() { return Counter{}.next(); }
}  // namespace mayfly
