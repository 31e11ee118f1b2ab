#include "fields/cache.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "fields/hash.hpp"
#include "tests/unit/fields_geometry/meshes.hpp"

namespace mayfly::fields {
namespace {

using test::Folder;

const std::vector<float> kValues{1.5F, -0.0F, std::numeric_limits<float>::infinity(), 1e-40F};

std::uint64_t hash_of(std::string_view text, std::uint64_t seed = 0) {
  return hash64(std::as_bytes(std::span(text.data(), text.size())), seed);
}

TEST(Hash, is_xxh64) {
  EXPECT_EQ(hash_of(""), 0xEF46DB3751D8E999U);
  EXPECT_EQ(hash_of("a"), 0xD24EC4F1A98C6E5BU);
  EXPECT_EQ(hash_of("abc"), 0x44BC2CF5AD770999U);
}

TEST(Hash, every_byte_counts) {
  const std::string text(100, 'x');
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string other = text;
    other[i] = 'y';
    EXPECT_NE(hash_of(text), hash_of(other)) << i;
  }
}

TEST(Hash, parts_do_not_run_into_each_other) {
  EXPECT_NE(ContentHash{}.add("ab").add("c").hex(), ContentHash{}.add("a").add("bc").hex());
}

TEST(FieldCache, gives_back_the_same_bits) {
  const Folder folder;
  const FieldCache cache(folder.path() / "deep" / "er");
  EXPECT_FALSE(cache.load("key", kValues.size()));
  cache.store("key", kValues);
  const auto found = cache.load("key", kValues.size());
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, kValues);
  EXPECT_TRUE(std::signbit((*found)[1]));
  EXPECT_FALSE(cache.load("other key", kValues.size()));
  EXPECT_FALSE(cache.load("key", kValues.size() + 1));
}

TEST(FieldCache, keeps_nothing_but_the_field) {
  const Folder folder;
  const FieldCache cache(folder.path());
  cache.store("key", kValues);
  cache.store("key", kValues);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    files += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(files, 1U);
}

TEST(FieldCache, any_damage_means_compute_again) {
  const Folder folder;
  const FieldCache cache(folder.path());
  cache.store("key", kValues);
  const auto file = cache.file_of("key");
  std::ifstream in(file, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), {});
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    folder.write(file.filename().string(), bad);
    EXPECT_FALSE(cache.load("key", kValues.size())) << "byte " << i;
    folder.write(file.filename().string(), good.substr(0, i));
    EXPECT_FALSE(cache.load("key", kValues.size())) << "cut at " << i;
  }
  folder.write(file.filename().string(), good + "x");
  EXPECT_FALSE(cache.load("key", kValues.size()));
  cache.store("key", kValues);
  EXPECT_TRUE(cache.load("key", kValues.size()));
}

TEST(FieldCache, without_a_place_to_write_it_is_no_error) {
  const Folder folder;
  const FieldCache below_a_file(folder.write("file", "x") / "cache");
  below_a_file.store("key", kValues);
  EXPECT_FALSE(below_a_file.load("key", kValues.size()));
  const FieldCache nowhere{std::filesystem::path()};
  nowhere.store("key", kValues);
  EXPECT_FALSE(nowhere.load("key", kValues.size()));
}

TEST(FieldCache, a_folder_in_the_files_place_is_no_error) {
  const Folder folder;
  const FieldCache cache(folder.path());
  std::filesystem::create_directories(cache.file_of("key") / "x");
  cache.store("key", kValues);
  EXPECT_FALSE(cache.load("key", kValues.size()));
}

TEST(FieldCache, its_folder_can_be_chosen) {
  const Folder folder;
  ASSERT_EQ(::setenv("MAYFLY_CACHE_DIR", folder.path().c_str(), 1), 0);
  EXPECT_EQ(FieldCache().file_of("key").parent_path(), folder.path());
  ::unsetenv("MAYFLY_CACHE_DIR");
  ASSERT_EQ(::setenv("XDG_CACHE_HOME", folder.path().c_str(), 1), 0);
  EXPECT_EQ(FieldCache().file_of("key").parent_path(), folder.path() / "mayfly");
  ::unsetenv("XDG_CACHE_HOME");
}

}  // namespace
}  // namespace mayfly::fields
