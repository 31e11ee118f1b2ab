#include "controller/scenario/schema.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "controller/scenario/schema_export.hpp"
#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {

// GoogleTest would print its bytes, addresses included, into the names that ctest lists.
void PrintTo(const Key& key, std::ostream* out) {
  *out << key.path;
}

namespace {

std::string content(const std::string& file) {
  std::ifstream stream(std::string(MAYFLY_SOURCE_DIR) + "/" + file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(Schema, CommittedFilesAreThoseOfTheTable) {
  constexpr const char* kHow = "build mayfly_schema_gen and run it on the top of the tree";
  EXPECT_TRUE(content("config/scenario.schema.json") == scenario_json_schema()) << kHow;
  EXPECT_TRUE(content("docs/reference/scenario.md") == scenario_reference_page()) << kHow;
}

TEST(Schema, EveryRowIsWhole) {
  std::set<std::string> paths;
  for (const Key& key : scenario_keys()) {
    EXPECT_TRUE(paths.insert(key.path).second) << key.path << " twice";
    EXPECT_TRUE(key.text.ends_with(".")) << key.path;
    EXPECT_EQ(find_key(key.path), &key);
    EXPECT_FALSE(key.required && !key.fallback.empty()) << key.path << " is required and has a default";
    EXPECT_FALSE(key.type == KeyType::kChoice && key.choices.empty()) << key.path;
    const bool is_number =
        key.type == KeyType::kNumber || key.type == KeyType::kInteger || key.type == KeyType::kVector;
    EXPECT_FALSE(is_number && !(std::isfinite(key.min) && std::isfinite(key.max)))
        << key.path << " has no range";
  }
}

// A one-line scenario that has nothing but the key, and the column at which its value stands.
struct OneKey {
  std::string text;
  int column;
};
OneKey only(const Key& key, const std::string& value) {
  std::string before;
  std::string after;
  std::string part;
  const auto close_part = [&] {
    if (!part.empty()) {
      before += fmt::format("{{{}: ", part == "*" ? "any" : part);
      after.insert(0, 1, '}');
      part.clear();
    }
  };
  for (const char c : key.path) {
    if (c == '.') {
      close_part();
    } else if (c == '[') {
      close_part();
      before += "[";
      after.insert(0, 1, ']');
    } else if (c != ']') {
      part += c;
    }
  }
  close_part();
  return {before + value + after, static_cast<int>(before.size()) + 1};
}

// What is said about the value of the key; other keys are missing, and said to be.
std::string said_of(const Key& key, const std::string& value) {
  const OneKey one = only(key, value);
  const auto result = test::load_text(one.text);
  std::string text;
  for (const Error& error : result ? std::vector<Error>{} : result.error()) {
    const bool is_missing = error.message.find("is missing") != std::string::npos ||
                            (error.message.starts_with("no ") && error.message.ends_with(" is given"));
    if (error.place && error.place->column == one.column && !is_missing) {
      text += to_string(error) + "\n";
    }
  }
  return text;
}

bool is_numeric(const Key& key) {
  return key.type == KeyType::kNumber || key.type == KeyType::kInteger;
}

std::string wrong_value(const Key& key) {
  switch (key.type) {
    case KeyType::kMap:
    case KeyType::kNamedMap:
    case KeyType::kList:
    case KeyType::kVector:
      return "5";
    default:
      return "{a: 1}";
  }
}

class EveryKey : public testing::TestWithParam<Key> {};

TEST_P(EveryKey, WrongTypeIsAnErrorAtItsPlace) {
  EXPECT_NE(said_of(GetParam(), wrong_value(GetParam())), "")
      << only(GetParam(), wrong_value(GetParam())).text;
  EXPECT_NE(said_of(GetParam(), "~"), "") << "nothing at all is no value either";
}

TEST_P(EveryKey, DefaultIsGood) {
  if (!GetParam().fallback.empty()) {
    EXPECT_EQ(said_of(GetParam(), GetParam().fallback), "");
  }
}

TEST_P(EveryKey, RangeIsKept) {
  const Key& key = GetParam();
  if (!is_numeric(key)) {
    return;
  }
  const auto text = [](double value) { return fmt::format("{:.17g}", value); };
  EXPECT_EQ(said_of(key, text(key.max)), "");
  EXPECT_EQ(said_of(key, text(key.min)) == "", !key.above_min);
  EXPECT_NE(said_of(key, text(key.min - 1.0)), "");
  EXPECT_NE(said_of(key, text(key.max + std::max(1.0, key.max * 1e-3))), "");
}

TEST_P(EveryKey, WhatIsNoNumberIsRefused) {
  if (!is_numeric(GetParam())) {
    return;
  }
  for (const char* value :
       {".nan", ".inf", "-.inf", "nan", "inf", "1e999", "0x10", "\"1\"", "1 parsec", "''", "--1", "+-1"}) {
    EXPECT_NE(said_of(GetParam(), value), "") << value;
  }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryKey, testing::ValuesIn(scenario_keys()), [](const auto& key) {
  std::string name;
  for (const char c : key.param.path) {
    name += c == '*' ? "any" : c == '[' ? "each" : c == ']' ? "" : std::string(1, c == '.' ? '_' : c);
  }
  return name;
});

}  // namespace
}  // namespace mayfly
