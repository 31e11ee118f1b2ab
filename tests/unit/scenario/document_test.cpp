#include "controller/scenario/document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mayfly {
namespace {

using testing::HasSubstr;

std::string problem_of(const std::string& text) {
  const auto tree = parse_yaml(text, "f.yaml");
  return tree ? "it parses" : to_string(tree.error());
}

TEST(Document, KnowsThePlaceOfEveryKeyAndValue) {
  const auto tree = parse_yaml("# note\nworld:\n  cell: 1.5\n  list: [a, \"b\"]\n", "f.yaml");
  ASSERT_TRUE(tree);
  ASSERT_EQ(tree->kind, YamlNode::Kind::kMap);
  EXPECT_EQ(tree->entries[0].mark.line, 2);
  EXPECT_EQ(tree->entries[0].mark.column, 1);
  const YamlNode& world = tree->entries[0].value;
  EXPECT_EQ(world.entries[0].mark.line, 3);
  EXPECT_EQ(world.entries[0].mark.column, 3);
  const YamlNode* cell = world.find("cell");
  ASSERT_NE(cell, nullptr);
  EXPECT_EQ(cell->mark.line, 3);
  EXPECT_EQ(cell->mark.column, 9);
  EXPECT_EQ(cell->mark.place().file, "f.yaml");
  const YamlNode* list = world.find("list");
  ASSERT_EQ(list->items.size(), 2U);
  EXPECT_FALSE(list->items[0].quoted);
  EXPECT_TRUE(list->items[1].quoted);
  EXPECT_EQ(list->items[1].mark.column, 13);
  EXPECT_EQ(world.find("nothing"), nullptr);
}

TEST(Document, EmptyTextIsNothing) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "---\n"}) {
    const auto tree = parse_yaml(text, "f.yaml");
    ASSERT_TRUE(tree) << text;
    EXPECT_EQ(tree->kind, YamlNode::Kind::kNull) << text;
  }
}

TEST(Document, DuplicateKeysNameBothPlaces) {
  EXPECT_THAT(problem_of("a: 1\nb: 2\n  \na: 3\n"),
              AllOf(HasSubstr("f.yaml:4:1"), HasSubstr("'a' is given twice"), HasSubstr("1:1")));
  EXPECT_THAT(problem_of("{a: 1, b: {a: 2}, \"a\": 3}"), HasSubstr("given twice"));
}

TEST(Document, RefusesWhatBombsAreMadeOf) {
  EXPECT_THAT(problem_of("a: &x 1\nb: *x\n"),
              AllOf(HasSubstr("f.yaml:1:4"), HasSubstr("anchors and aliases")));
  EXPECT_THAT(problem_of("a: !!binary aaaa\n"), HasSubstr("tags"));
  EXPECT_THAT(problem_of("%TAG ! tag:x,2000:\n---\na: !b c\n"), HasSubstr("tags"));
  EXPECT_THAT(problem_of("a: 1\n---\nb: 1\n"), AllOf(HasSubstr("f.yaml:2:1"), HasSubstr("second document")));
  EXPECT_THAT(problem_of("? [a]\n: 1\n"), HasSubstr("cannot be a key"));
}

TEST(Document, CapsAreExact) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_EQ(problem_of(nested(kMaxYamlDepth)), "it parses");
  EXPECT_THAT(problem_of(nested(kMaxYamlDepth + 1)), HasSubstr("nested too deeply"));
  const auto list = [](std::size_t items) {
    std::string text;
    for (std::size_t i = 0; i < items; ++i) {
      text += "- 1\n";
    }
    return text;
  };
  EXPECT_EQ(problem_of(list(kMaxYamlItems - 1)), "it parses");  // the list is an item too
  EXPECT_THAT(problem_of(list(kMaxYamlItems)), HasSubstr("too many items"));
  EXPECT_EQ(problem_of("a: 1 #" + std::string(kMaxYamlBytes - 6, 'x')), "it parses");
  EXPECT_THAT(problem_of("a: 1 #" + std::string(kMaxYamlBytes - 5, 'x')), HasSubstr("bytes"));
}

// Large inputs that have no depth that a person would write: they must be refused, and soon.
TEST(Document, SurvivesDeepAndLongInput) {
  const std::size_t full = kMaxYamlBytes / 4;
  for (const std::string piece :
       {"[",   "{",      "- ",    "? ",    "a: ", "[a: ", "{a: {", "\"",    "'",     "|\n", ">\n ", "!",
        "&a ", "- - ? ", "\n\n ", "a:\n ", ",",   ":",    "%",     "...\n", "---\n", "{?",  "[[:",  "!<"}) {
    std::string text;
    while (text.size() + piece.size() <= full) {
      text += piece;
    }
    EXPECT_NE(problem_of(text), "") << piece;
  }
  std::string stairs;
  for (std::size_t indent = 0; stairs.size() < full / 2; ++indent) {
    stairs += std::string(indent, ' ') + "a:\n";
  }
  EXPECT_THAT(problem_of(stairs), HasSubstr("nested too deeply"));
}

TEST(Document, TakesTextOnly) {
  EXPECT_THAT(problem_of(std::string("a: 1\nb: x\0y", 11)),
              AllOf(HasSubstr("f.yaml:2:5"), HasSubstr("control")));
  EXPECT_THAT(problem_of("a: \xC0\x80"), HasSubstr("UTF-8"));
  EXPECT_THAT(problem_of("\xFF\xFE"
                         "a\0:\0"),
              HasSubstr("UTF-8"));
  EXPECT_THAT(problem_of("a: \"\\x1b[31m\""), HasSubstr("control character"));
  EXPECT_EQ(problem_of("a: Größe ≥ 3\n"), "it parses");
  EXPECT_EQ(problem_of("a: 1\r\nb: 2\r\n"), "it parses");
}

TEST(Document, ValueThatIsLeftOutIsAtItsKey) {
  const auto tree = parse_yaml("a: 1\nb:\nc: 3\n", "f.yaml");
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->find("b")->kind, YamlNode::Kind::kNull);
  EXPECT_EQ(tree->find("b")->mark.line, 2);
  EXPECT_EQ(tree->find("b")->mark.column, 1);
}

}  // namespace
}  // namespace mayfly
