// What can go wrong while something is being set up, as a value. In the loop nothing is thrown and nothing
// allocates: see HalResult in core/hal.hpp for what the loop uses instead.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace mayfly {

// Who has to act: the caller mends the input, the environment is the machine (a missing file, no memory, no
// device driver), the device is a robot or its link.
enum class Cause { kCaller, kEnvironment, kDevice };

// A place in a text file that a person wrote; lines and columns count from 1, 0 means "not known".
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

// One problem: what is wrong, where, what was found there, what was wanted, and the nearest valid name, if
// one is near.
struct Error {
  Cause cause = Cause::kCaller;
  std::string message;
  std::optional<Place> place{};
  std::string found{};
  std::string wanted{};
  std::string suggestion{};
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(Cause cause, std::string message) {
  return tl::unexpected<Error>(Error{cause, std::move(message)});
}

inline tl::unexpected<Error> fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

// "swarm.yaml:12:5: unknown key 'gaol'; wanted one of …; did you mean 'goal'?"
inline std::string to_string(const Error& error) {
  std::string text;
  if (error.place) {
    text += error.place->file;
    if (error.place->line > 0) {
      text += ':' + std::to_string(error.place->line) + ':' + std::to_string(error.place->column);
    }
    text += ": ";
  }
  text += error.message;
  if (!error.found.empty()) {
    text += "; found " + error.found;
  }
  if (!error.wanted.empty()) {
    text += "; wanted " + error.wanted;
  }
  if (!error.suggestion.empty()) {
    text += "; did you mean '" + error.suggestion + "'?";
  }
  return text;
}

}  // namespace mayfly
