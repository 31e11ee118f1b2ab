// What the program tells whoever started it.
#pragma once

#include "core/result.hpp"

namespace mayfly::app {

// Stopped by a signal, the program ends with 128 + its number, as programs do: 130 for Ctrl-C, 143 for
// SIGTERM.
enum ExitCode : int {
  kSuccess = 0,
  kExpectationBroken = 1,  // it flew, and one of its `expect` lines does not hold
  kBadInput = 2,           // a scenario, mesh or command line to be mended
  kMachineOrRobot = 3,     // no device, no memory, a full disk; a HAL that refused
};

inline ExitCode exit_code_of(const Error& error) {
  return error.cause == Cause::kCaller ? kBadInput : kMachineOrRobot;
}

}  // namespace mayfly::app
