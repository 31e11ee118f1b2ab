#include "record/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace mayfly::record {
namespace {

// In an attribute: XML 1.0 has no control characters, and turns line ends into blanks.
std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
        out += "&#10;";
        break;
      case '\t':
        out += "&#9;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20U ? '?' : c;
    }
  }
  return out + '"';
}

struct Count {
  std::size_t tests = 0, failures = 0, errors = 0;
  double seconds = 0.0;

  void add(const JUnitCase& one) {
    ++tests;
    failures += one.error.empty() && !one.failure.empty() ? 1U : 0U;
    errors += one.error.empty() ? 0U : 1U;
    seconds += one.seconds;
  }
  std::string text() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", tests, failures, errors,
                       seconds);
  }
};

template <class Wanted>
Count count(const std::vector<JUnitCase>& cases, Wanted&& wanted) {
  Count count;
  for (const JUnitCase& one : cases) {
    if (wanted(one)) {
      count.add(one);
    }
  }
  return count;
}

void add_case(std::string& out, const JUnitCase& one) {
  out += fmt::format("    <testcase classname={} name={} time=\"{:.3f}\"", quoted(one.suite),
                     quoted(one.name), one.seconds);
  if (!one.error.empty()) {
    out += fmt::format("><error message={}/></testcase>\n", quoted(one.error));
  } else if (!one.failure.empty()) {
    out += fmt::format("><failure message={}/></testcase>\n", quoted(one.failure));
  } else {
    out += "/>\n";
  }
}

}  // namespace

std::string to_junit(std::string_view name, const std::vector<JUnitCase>& cases) {
  std::vector<std::string> suites;
  for (const JUnitCase& one : cases) {
    if (std::find(suites.begin(), suites.end(), one.suite) == suites.end()) {
      suites.push_back(one.suite);
    }
  }
  std::string out = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name={} {}>\n",
                                quoted(name), count(cases, [](const JUnitCase&) { return true; }).text());
  for (const std::string& suite : suites) {
    out += fmt::format("  <testsuite name={} {}>\n", quoted(suite),
                       count(cases, [&](const JUnitCase& one) { return one.suite == suite; }).text());
    for (const JUnitCase& one : cases) {
      if (one.suite == suite) {
        add_case(out, one);
      }
    }
    out += "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

}  // namespace mayfly::record
