// The reference pages name everything there is, and nothing that is not.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "controller/faults/fault_table.hpp"
#include "controller/guard/invariants.hpp"
#include "controller/safety/reaction_table.hpp"
#include "record/csv_text.hpp"
#include "record/summary_json.hpp"
#include "tests/docs/page.hpp"
#include "tests/sim/program/process.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {
namespace {

using Names = std::set<std::string>;

const std::string kReference = MAYFLY_SOURCE_DIR "/docs/reference/";

// What stands in backquotes in the first column of the page's tables.
Names first_column(const std::string& page) {
  static const std::regex kRow(R"(\n\|([^|]*)\|)");
  static const std::regex kName(R"(`([^` ]+)[^`]*`)");
  const std::string text = text_of(kReference + page);
  Names names;
  for (std::sregex_iterator row(text.begin(), text.end(), kRow), end; row != end; ++row) {
    const std::string cell = (*row)[1];
    for (std::sregex_iterator name(cell.begin(), cell.end(), kName); name != end; ++name) {
      names.insert((*name)[1]);
    }
  }
  return names;
}

void add_keys(const nlohmann::json& value, const std::string& path, Names& names) {
  if (value.is_array() && !value.empty()) {
    add_keys(value.front(), path + "[]", names);
  } else if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) {
      add_keys(inner, path.empty() ? key : path + '.' + key, names);
    }
  } else {
    names.insert(path);
  }
}

TEST(Reference, SummaryPageHasEveryKeyOfTheFile) {
  Summary summary;
  summary.faults.emplace_back();
  summary.expect.emplace_back();
  summary.safety.breaches.emplace();
  for (std::size_t i = 0; i < kInvariants; ++i) {
    summary.safety.invariants.emplace_back(key_of(static_cast<Invariant>(i)), 0);
  }
  for (std::size_t i = 1; i < kSeverities; ++i) {
    summary.safety.reactions.emplace_back(key_of(static_cast<Severity>(i)), 0);
  }
  summary.control.tasks.emplace_back();
  summary.control.ages.emplace_back();
  Names keys;
  add_keys(nlohmann::json::parse(record::to_json(summary)), "", keys);
  EXPECT_EQ(first_column("summary.md"), keys);
}

TEST(Reference, RecordingPageHasEveryColumn) {
  Names columns;
  std::istringstream header{std::string(record::kCsvHeader.substr(0, record::kCsvHeader.size() - 1))};
  for (std::string column; std::getline(header, column, ',');) {
    columns.insert(column);
  }
  EXPECT_EQ(first_column("recording-csv.md"), columns);
}

TEST(Reference, FaultsPageHasTheTableOfTheProgram) {
  const std::string table = fault_reference_table();
  EXPECT_NE(text_of(kReference + "faults.md").find(table), std::string::npos)
      << "docs/reference/faults.md has to have this table:\n"
      << table;
}

TEST(Reference, BenchPageHasEveryKeyOfTheJson) {
  const auto noise =
      run_program({"bench", "noise", "--json", "--agents", "8", "--duration", "1", "--seeds", "1"});
  const auto fields = run_program({"bench", "fields", "--json", "--agents", "1024"});
  const auto forces = run_program({"bench", "forces", "--json", "--agents", "1000"});
  const auto faults = run_program({"bench", "faults", "--json", "--seeds", "1"});
  const auto governor = run_program({"bench", "governor", "--json", "--duration", "1"});
  Names keys, without_spread;
  add_keys(nlohmann::json::parse(faults.out), "", keys);
  add_keys(nlohmann::json::parse(noise.out), "", keys);
  add_keys(nlohmann::json::parse(fields.out), "", keys);
  add_keys(nlohmann::json::parse(forces.out), "", keys);
  add_keys(nlohmann::json::parse(governor.out), "", keys);
  keys.erase("curves");  // of a bench without any
  // A measure's spread, and the names of a figure's lines.
  static const std::regex kSpread(R"((\.(mean|least|most)|(\.lines)\..*)$)");
  for (const std::string& key : keys) {
    without_spread.insert(std::regex_replace(key, kSpread, "$3"));
  }
  EXPECT_EQ(first_column("bench.md"), without_spread);
}

TEST(Reference, CommandLinePageHasEveryCommandAndOption) {
  static const std::regex kOption(R"(--[a-z-]+)");
  Names there{"run", "check", "test", "guard", "doctor", "bench"};
  for (const std::string command : {"", "run", "check", "test", "guard", "doctor", "bench"}) {
    const std::string help =
        command.empty() ? run_program({"--help"}).out : run_program({command, "--help"}).out;
    const std::string options = help.substr(0, help.find("Example:"));
    for (std::sregex_iterator option(options.begin(), options.end(), kOption), end; option != end; ++option) {
      // "Threads …; unless --fast" names an option as well: no harm.
      there.insert(option->str());
    }
  }
  EXPECT_EQ(first_column("command-line.md"), there);
}

}  // namespace
}  // namespace mayfly::test
