#include "controller/scenario/brackets.hpp"

#include <vector>

namespace mayfly {
namespace {

struct Bracket {
  char open;
  int line;
  int column;
};

char closing(char open) {
  return open == '[' ? ']' : '}';
}

std::string place_text(const Bracket& bracket) {
  return std::string("'") + bracket.open + "' of " + std::to_string(bracket.line) + ":" +
         std::to_string(bracket.column);
}

// Reads the text as far as needed to know which brackets count: not those in quotes and comments.
class Scan {
 public:
  std::optional<YamlSlip> run(std::string_view text, int last_line) {
    for (const char c : text) {
      if (c == '\n') {
        next_line();
        continue;
      }
      ++column_;
      if (c == '\t' && in_indent_ && open_.empty() && quote_ == 0 && line_ <= last_line) {
        return YamlSlip{line_, column_, "a tab indents this line", "spaces"};
      }
      in_indent_ = in_indent_ && (c == ' ' || c == '\t');
      if (auto slip = step(c)) {
        return slip;
      }
      before_ = c;
    }
    if (!open_.empty()) {
      const Bracket& last = open_.back();
      return YamlSlip{last.line, last.column, std::string("this '") + last.open + "' is never closed",
                      std::string("'") + closing(last.open) + "'"};
    }
    return std::nullopt;
  }

 private:
  void next_line() {
    ++line_;
    column_ = 0;
    in_indent_ = true;
    in_comment_ = false;
    before_ = ' ';
  }

  bool at_token_start() const { return std::string_view(" \t[{,:").find(before_) != std::string_view::npos; }

  std::optional<YamlSlip> step(char c) {
    if (in_comment_) {
      return std::nullopt;
    }
    if (quote_ != 0) {
      const bool is_escaped = quote_ == '"' && before_ == '\\';
      quote_ = c == quote_ && !is_escaped ? 0 : quote_;
      return std::nullopt;
    }
    if (c == '#' && (before_ == ' ' || before_ == '\t')) {
      in_comment_ = true;
    } else if ((c == '"' || c == '\'') && at_token_start()) {
      quote_ = c;
    } else if ((c == '[' || c == '{') && (at_token_start() || !open_.empty())) {
      open_.push_back({c, line_, column_});
    } else if ((c == ']' || c == '}') && !open_.empty()) {
      return close(c);
    }
    return std::nullopt;
  }

  std::optional<YamlSlip> close(char c) {
    const Bracket last = open_.back();
    if (closing(last.open) != c) {
      return YamlSlip{line_, column_, std::string("'") + c + "' does not close the " + place_text(last),
                      std::string("'") + closing(last.open) + "' before it"};
    }
    open_.pop_back();
    return std::nullopt;
  }

  int line_ = 1;
  int column_ = 0;
  bool in_indent_ = true;
  bool in_comment_ = false;
  char quote_ = 0;
  char before_ = ' ';
  std::vector<Bracket> open_;
};

}  // namespace

std::optional<YamlSlip> find_yaml_slip(std::string_view text, int last_line) {
  return Scan().run(text, last_line);
}

}  // namespace mayfly
