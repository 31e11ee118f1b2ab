// bites: unused
namespace mayfly {
void idle() { int nobody = 0; }
}  // namespace mayfly
