// The small readers: numbers, comparisons, names that are near.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "controller/scenario/numbers.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

TEST(EditDistance, CountsChanges) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("goal", "goal"), 0U);
  EXPECT_EQ(edit_distance("gaol", "goal"), 1U);  // neighbours swapped
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(EditDistance, IsSymmetricAndKeepsTheTriangle) {
  const std::vector<std::string> words = {"", "a", "goal", "gaol", "coal", "count", "cruise_speed", "speed"};
  for (const auto& a : words) {
    for (const auto& b : words) {
      EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
      EXPECT_EQ(edit_distance(a, b) == 0, a == b);
    }
  }
}

TEST(NearestName, IsFoundOrLeft) {
  const std::vector<std::string> names = {"goal", "goals", "count", "cruise_speed", "fit"};
  EXPECT_EQ(nearest_name("gaol", names), "goal");
  EXPECT_EQ(nearest_name("Cruise-Speed", names), "cruise_speed");
  EXPECT_EQ(nearest_name("coutn", names), "count");
  EXPECT_EQ(nearest_name("elephant", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("xyz", names), "");
  EXPECT_EQ(nearest_name(std::string(100'000, 'g'), names), "");
  EXPECT_EQ(nearest_name("goal", {}), "");
}

TEST(ListNames, ReadsLikeASentence) {
  const std::vector<std::string> names = {"a", "b", "c"};
  EXPECT_EQ(list_names(names), "a, b or c");
  EXPECT_EQ(list_names(std::span(names).first(1)), "a");
  EXPECT_EQ(list_names({}), "");
}

TEST(Numbers, AreReadWithWhatIsBehindThem) {
  EXPECT_EQ(*read_number("1.5").value, 1.5);
  EXPECT_EQ(*read_number(" -2e3 ").value, -2000.0);
  EXPECT_EQ(*read_number("+4").value, 4.0);
  EXPECT_EQ(read_number("1.5 m").rest, "m");
  EXPECT_EQ(read_number("3m/s").rest, "m/s");
  EXPECT_TRUE(std::isnan(*read_number(".NaN").value));
  EXPECT_TRUE(std::isinf(*read_number("-.inf").value));
  for (const char* text : {"", "abc", "+-1", "--1", "1e999", "-"}) {
    EXPECT_FALSE(read_number(text).value) << text;
  }
}

TEST(Numbers, WholeOnesAreDigitsOnly) {
  EXPECT_EQ(read_integer("42"), 42);
  EXPECT_EQ(read_integer("-7"), -7);
  for (const char* text : {"", "4.0", "1e3", "0x10", "12 ", "99999999999999999999", "+-1"}) {
    EXPECT_EQ(read_integer(text), text == std::string("12 ") ? std::optional<long long>(12) : std::nullopt)
        << text;
  }
}

TEST(Comparisons, KnowTheLongerSpelling) {
  using Comparison = Expectation::Comparison;
  EXPECT_EQ(read_comparison(">= 0.2")->comparison, Comparison::kGreaterEqual);
  EXPECT_EQ(read_comparison(">0.2")->comparison, Comparison::kGreater);
  EXPECT_EQ(read_comparison("<=1")->comparison, Comparison::kLessEqual);
  EXPECT_EQ(read_comparison(" < 1 ")->comparison, Comparison::kLess);
  EXPECT_EQ(read_comparison("== 0")->number, "0");
  EXPECT_FALSE(read_comparison("0"));
  EXPECT_FALSE(read_comparison("= 0"));
  EXPECT_FALSE(read_comparison(""));
}

TEST(Units, ConvertWithinWhatTheyMeasure) {
  EXPECT_DOUBLE_EQ(*convert_unit(50, "cm", "m"), 0.5);
  EXPECT_DOUBLE_EQ(*convert_unit(36, "km/h", "m/s"), 10.0);
  EXPECT_DOUBLE_EQ(*convert_unit(2, "min", "s"), 120.0);
  EXPECT_FALSE(convert_unit(1, "m", "s"));
  EXPECT_FALSE(convert_unit(1, "parsec", "m"));
}

}  // namespace
}  // namespace mayfly
