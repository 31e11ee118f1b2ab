#include "compute/sources.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>

namespace mayfly::compute {

namespace {

constexpr std::string_view kInclude = "#include \"kernels/";

std::string line_mark(std::size_t line, std::string_view file) {
  return "#line " + std::to_string(line) + " \"kernels/" + std::string(file) + "\"\n";
}

// cmake/EmbedKernels.cmake does the same at build time; a test holds the two together.
class Flattener {
 public:
  explicit Flattener(std::filesystem::path folder) : folder_(std::move(folder)) {}

  Result<void> add(const std::string& file) {
    if (!seen_.insert(file).second) {
      return {};
    }
    std::ifstream stream(folder_ / file, std::ios::binary);
    if (!stream) {
      return fail(Cause::kEnvironment, "cannot read the kernel source " + (folder_ / file).string());
    }
    text_ += line_mark(1, file);
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
      if (!line.starts_with(kInclude)) {
        text_ += line + '\n';
        continue;
      }
      const std::string name =
          line.substr(kInclude.size(), line.find('"', kInclude.size()) - kInclude.size());
      if (auto added = add(name); !added) {
        return added;
      }
      text_ += line_mark(number + 1, file);
    }
    return {};
  }

  std::string take() { return std::move(text_); }

 private:
  std::filesystem::path folder_;
  std::set<std::string> seen_;
  std::string text_;
};

}  // namespace

Result<std::string> flatten_kernel(const std::filesystem::path& kernel_folder, std::string_view name) {
  Flattener flattener(kernel_folder);
  if (auto added = flattener.add(std::string(name) + ".cl"); !added) {
    return fail(std::move(added.error()));
  }
  return flattener.take();
}

Result<std::string> kernel_source(std::string_view name) {
  if (const char* folder = std::getenv("MAYFLY_KERNEL_DIR"); folder != nullptr && *folder != '\0') {
    return flatten_kernel(folder, name);
  }
  const auto sources = embedded_sources();
  const auto found = std::find_if(sources.begin(), sources.end(),
                                  [name](const auto& source) { return source.name == name; });
  if (found == sources.end()) {
    return fail(Cause::kCaller, "no kernel source called '" + std::string(name) + "' is built in");
  }
  return std::string(found->text);
}

}  // namespace mayfly::compute
