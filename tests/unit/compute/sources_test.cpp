#include "compute/sources.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "compute/program.hpp"

namespace mayfly::compute {
namespace {

const std::filesystem::path kKernels = std::filesystem::path(MAYFLY_SOURCE_DIR) / "kernels";

class EmbeddedKernel : public ::testing::TestWithParam<EmbeddedSource> {};

TEST_P(EmbeddedKernel, CompilesAlone) {
  const auto device = Device::open();
  ASSERT_TRUE(device.has_value());
  // The name is a comment, so that no other test's cached binary stands in for the compiler.
  const std::string source = std::string(GetParam().text) + "// compiled alone\n";
  const auto program = Program::build_source(*device, GetParam().name, source, "-Werror");
  ASSERT_TRUE(program.has_value()) << to_string(program.error());
}

TEST_P(EmbeddedKernel, IsWhatFlatteningAtRunTimeGives) {
  const auto now = flatten_kernel(kKernels, GetParam().name);
  ASSERT_TRUE(now.has_value()) << to_string(now.error());
  EXPECT_EQ(*now, GetParam().text);
}

TEST_P(EmbeddedKernel, IncludesNothingAnyMore) {
  EXPECT_EQ(GetParam().text.find("#include \"kernels/"), std::string_view::npos);
}

INSTANTIATE_TEST_SUITE_P(All, EmbeddedKernel,
                         ::testing::ValuesIn(embedded_sources().begin(), embedded_sources().end()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(KernelSource, AllFilesAreEmbedded) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kKernels)) {
    files += entry.path().extension() == ".cl" ? 1 : 0;
  }
  EXPECT_EQ(embedded_sources().size(), files);
}

TEST(KernelSource, AnUnknownNameIsAnError) {
  const auto source = kernel_source("no_such");
  ASSERT_FALSE(source.has_value());
  EXPECT_EQ(source.error().cause, Cause::kCaller);
}

TEST(KernelSource, ComesFromDiskWhileDeveloping) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("kernels_on_disk_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.cl") << "// first; line\n#include \"kernels/b.h\"\nlast\n";
  std::ofstream(folder / "b.h") << "#include \"kernels/c.h\"\nof b\n#include \"kernels/c.h\"\n";
  std::ofstream(folder / "c.h") << "of c\n";
  setenv("MAYFLY_KERNEL_DIR", folder.c_str(), 1);
  const auto source = kernel_source("a");
  const auto missing = kernel_source("b");
  unsetenv("MAYFLY_KERNEL_DIR");
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(*source,
            "#line 1 \"kernels/a.cl\"\n// first; line\n"
            "#line 1 \"kernels/b.h\"\n#line 1 \"kernels/c.h\"\nof c\n#line 2 \"kernels/b.h\"\nof b\n"
            "#line 4 \"kernels/b.h\"\n#line 3 \"kernels/a.cl\"\nlast\n");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().cause, Cause::kEnvironment);
}

}  // namespace
}  // namespace mayfly::compute
