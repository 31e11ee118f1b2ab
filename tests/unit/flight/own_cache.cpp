// A cache folder for each process, empty at its start and gone after it: whether a field was computed or kept
// is what is tested here. Linked in, it acts before any test does.
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

class OwnCache {
 public:
  OwnCache() : folder_((std::filesystem::temp_directory_path() / "mayfly-flight-XXXXXX").string()) {
    if (mkdtemp(folder_.data()) == nullptr || setenv("MAYFLY_CACHE_DIR", folder_.c_str(), 1) != 0) {
      std::abort();
    }
  }
  OwnCache(const OwnCache&) = delete;
  OwnCache& operator=(const OwnCache&) = delete;
  ~OwnCache() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

 private:
  std::string folder_;
};

[[maybe_unused]] const OwnCache kCache;

}  // namespace
