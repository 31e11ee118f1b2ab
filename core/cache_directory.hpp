// Where this user's caches live. A cache only saves time: whoever uses it works as well where there is none.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace mayfly {

// $MAYFLY_CACHE_DIR, else $XDG_CACHE_HOME/mayfly, else ~/.cache/mayfly; nothing where none of the three is
// set. The folder may not exist yet. The XDG specification has relative paths ignored.
inline std::optional<std::filesystem::path> cache_directory() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::filesystem::path(value == nullptr ? "" : value);
  };
  if (const auto own = variable("MAYFLY_CACHE_DIR"); !own.empty()) {
    return {own};
  }
  if (const auto xdg = variable("XDG_CACHE_HOME"); xdg.is_absolute()) {
    return xdg / "mayfly";
  }
  if (const auto home = variable("HOME"); home.is_absolute()) {
    return home / ".cache" / "mayfly";
  }
  return std::nullopt;
}

}  // namespace mayfly
