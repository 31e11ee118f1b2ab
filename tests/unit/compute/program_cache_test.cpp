// The cache only ever saves time: whatever happens to it, programs are built.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "compute/program.hpp"

namespace mayfly::compute {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSource = "__kernel void one(__global float* v) { v[get_global_id(0)] = 1.0f; }";

class ProgramCache : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) /
              (std::string("program_cache_") + test->name() + "_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    old_ = std::getenv("MAYFLY_CACHE_DIR");
    setenv("MAYFLY_CACHE_DIR", folder_.c_str(), 1);
    before_ = program_counters();
  }
  void TearDown() override {
    setenv("MAYFLY_CACHE_DIR", old_.c_str(), 1);
    fs::remove_all(folder_);
  }
  // Builds, and proves that the program works.
  bool build(std::string_view source = kSource, std::string_view options = {}) {
    const auto device = Device::open();
    const auto program = Program::build_source(*device, "one", source, options);
    EXPECT_TRUE(program.has_value()) << to_string(program.error());
    auto kernel = program->kernel("one");
    auto values = Buffer<float>::create(*device, 16);
    EXPECT_TRUE(values->unmap().ok() && kernel->set(*values).ok() && kernel->enqueue(16, 16).ok() &&
                values->map().ok());
    EXPECT_EQ(values->data()[15], 1.0F);
    return program->from_cache();
  }
  fs::path file() const {
    const fs::directory_iterator entries(folder_ / "programs");
    return std::distance(begin(entries), end(entries)) == 1
               ? fs::directory_iterator(folder_ / "programs")->path()
               : fs::path();
  }
  std::string content() const {
    std::ifstream stream(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  void overwrite(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }
  std::uint64_t rejected() const { return program_counters().rejected - before_.rejected; }
  std::uint64_t compiled() const { return program_counters().compiled - before_.compiled; }
  std::uint64_t unstored() const { return program_counters().unstored - before_.unstored; }

  fs::path folder_;
  std::string old_;
  ProgramCounters before_;
};

TEST_F(ProgramCache, TheSecondBuildComesFromDisk) {
  EXPECT_FALSE(build());
  EXPECT_FALSE(file().empty());  // and no temporary file beside it
  EXPECT_TRUE(build());
  EXPECT_EQ(compiled(), 1U);
  EXPECT_EQ(rejected(), 0U);
  EXPECT_EQ(program_counters().from_cache - before_.from_cache, 1U);
}

TEST_F(ProgramCache, AnotherSourceOrOptionIsAnotherProgram) {
  EXPECT_FALSE(build());
  EXPECT_FALSE(build(std::string(kSource) + " "));
  EXPECT_FALSE(build(kSource, "-DANY=1"));
  EXPECT_EQ(compiled(), 3U);
}

TEST_F(ProgramCache, ATruncatedFileMeansCompile) {
  build();
  const std::string whole = content();
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, whole.size() / 2, whole.size() - 1}) {
    overwrite(whole.substr(0, length));
    EXPECT_FALSE(build()) << length;
    EXPECT_EQ(content().size(), whole.size()) << length;  // mended
  }
  EXPECT_EQ(rejected(), 4U);
}

TEST_F(ProgramCache, AGarbledFileMeansCompile) {
  build();
  const std::string whole = content();
  for (const std::size_t at : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
    std::string garbled = whole;
    garbled[at] = static_cast<char>(garbled[at] ^ 0x20);
    overwrite(garbled);
    EXPECT_FALSE(build()) << at;
  }
  EXPECT_EQ(rejected(), 3U);
}

// The key, which holds the device and the driver, is stored whole and compared.
TEST_F(ProgramCache, AFileOfAnotherDeviceMeansCompile) {
  build();
  std::string other = content();
  const std::size_t at = other.find(list_devices().at(0).driver);
  ASSERT_NE(at, std::string::npos);
  other[at] = '9';
  overwrite(other);
  EXPECT_FALSE(build());
  EXPECT_EQ(rejected(), 1U);
}

// Whole by its checksum, but the device does not take it.
TEST_F(ProgramCache, ABinaryThatTheDeviceRefusesMeansCompile) {
  build();
  const std::string whole = content();
  const std::size_t head = whole.find(kSource) + kSource.size();
  std::string text = whole.substr(0, head) + "this is no program";
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  for (int byte = 0; byte < 8; ++byte) {
    text += static_cast<char>((hash >> (8 * byte)) & 0xffU);
  }
  overwrite(text);
  EXPECT_FALSE(build());
  EXPECT_EQ(rejected(), 1U);
  EXPECT_EQ(content().size(), whole.size());
}

TEST_F(ProgramCache, AFolderThatCannotBeMadeMeansCompile) {
  std::ofstream(folder_) << "a file where the folder should be";
  EXPECT_FALSE(build());
  EXPECT_FALSE(build());
  EXPECT_EQ(compiled(), 2U);
  EXPECT_EQ(unstored(), 2U);
}

TEST_F(ProgramCache, AFileThatCannotBeReplacedMeansCompile) {
  build();
  const fs::path taken = file();
  fs::remove(taken);
  fs::create_directories(taken / "in the way");
  EXPECT_FALSE(build());
  EXPECT_EQ(rejected(), 1U);
  EXPECT_EQ(unstored(), 1U);
}

}  // namespace
}  // namespace mayfly::compute
