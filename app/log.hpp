// What the program says about its own doings, on stderr.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace mayfly::app {

// Details are shown only where `verbose`.
void set_up_log(bool verbose);
void log_detail(const std::string& text);
void log_warning(const std::string& text);

// One line each.
void print_errors(std::span<const Error> errors);

}  // namespace mayfly::app
