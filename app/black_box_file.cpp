#include "app/black_box_file.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "app/log.hpp"
#include "record/black_box_csv.hpp"
#include "record/output_file.hpp"

namespace mayfly::app {

std::filesystem::path black_box_file(const std::filesystem::path& record, const std::string& scenario) {
  std::filesystem::path path = record.empty() ? std::filesystem::path("out") / scenario : record;
  path.replace_extension(".blackbox.csv");
  return path;
}

void write_black_box(const std::filesystem::path& file, std::span<const RobotInfo> robots,
                     const BlackBoxTape& tape) {
  std::vector<std::string> names;
  names.reserve(robots.size());
  for (const RobotInfo& robot : robots) {
    names.push_back(robot.name);
  }
  std::error_code ignored;  // where there is no folder, writing says so
  std::filesystem::create_directories(file.parent_path(), ignored);
  if (auto written = record::write_file(file, record::black_box_csv(tape, names)); !written) {
    print_errors(std::span(&written.error(), 1));
  } else {
    log_warning(fmt::format("the guard's last seconds before it had to act are in '{}'", file.string()));
  }
}

}  // namespace mayfly::app
