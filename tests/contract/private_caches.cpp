// Tests that use OpenCL keep their caches, ours and PoCL's, in the build tree: what a user's own caches hold
// must neither help nor hurt them. Linked in, it acts before any test does.
#include <cstdlib>
#include <filesystem>

namespace {

[[maybe_unused]] const bool kDone = [] {
  for (const char* variable : {"MAYFLY_CACHE_DIR", "POCL_CACHE_DIR"}) {
    const auto folder = std::filesystem::path(MAYFLY_BINARY_DIR) / "tests" / "caches" / variable;
    std::error_code ignored;  // without a cache everything works as well
    std::filesystem::create_directories(folder, ignored);
    setenv(variable, folder.c_str(), 1);
  }
  return true;
}();

}  // namespace
