// How long work tells how far it is.
#pragma once

#include <functional>
#include <string_view>

namespace mayfly {

// Called from any thread, at most a few times a second; fraction in [0, 1]. May be empty.
using Progress = std::function<void(std::string_view stage, double fraction)>;

}  // namespace mayfly
