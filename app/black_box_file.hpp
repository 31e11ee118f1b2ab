// Where a guard's black box is written, and that.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "controller/guard/black_box.hpp"
#include "core/hal.hpp"

namespace mayfly::app {

// Beside `record`, else below out/: something went wrong, and nobody had asked for a file.
std::filesystem::path black_box_file(const std::filesystem::path& record, const std::string& scenario);

// Says where it is, or why it could not be written.
void write_black_box(const std::filesystem::path& file, std::span<const RobotInfo> robots,
                     const BlackBoxTape& tape);

}  // namespace mayfly::app
