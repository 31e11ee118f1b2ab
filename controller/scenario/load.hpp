// Reads a scenario file: every problem of it at once, each with its place.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "controller/scenario/override.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// Either a scenario in which everything that its file alone can show is right, or at least one error. Left to
// whoever builds the fields: what is inside meshes, goals that cannot be reached, starts inside obstacles.
using ScenarioResult = tl::expected<Scenario, std::vector<Error>>;

ScenarioResult load_scenario(const std::filesystem::path& file, std::span<const Override> overrides = {});

// The same from text that is already in memory; `file` is what messages call it and where its relative paths
// start.
ScenarioResult load_scenario_text(std::string_view text, const std::filesystem::path& file,
                                  std::span<const Override> overrides = {});

}  // namespace mayfly
