#include "controller/scenario/load.hpp"

#include <utility>

#include "controller/scenario/build.hpp"
#include "controller/scenario/check.hpp"
#include "controller/scenario/document.hpp"
#include "controller/scenario/memory.hpp"
#include "controller/scenario/preset.hpp"

namespace mayfly {
namespace {

using Failure = tl::unexpected<std::vector<Error>>;

Failure failure(Error error) {
  return Failure(std::vector<Error>{std::move(error)});
}

ScenarioResult build_scenario(const YamlNode& root, const std::filesystem::path& file,
                              const FileRoots& roots) {
  const Values top(&root, "");
  Findings findings;
  Scenario scenario;
  scenario.file = file;
  scenario.name = top.has("name") ? top.text("name") : file.stem().string();
  scenario.seed = static_cast<std::uint64_t>(top.integer("seed"));
  scenario.duration = top.number("duration");
  scenario.control.rate = top.map("control").number_f("rate");
  scenario.control.realtime =
      top.map("control").choice("realtime") == 0 ? RealtimePolicy::kIgnore : RealtimePolicy::kEnforce;
  scenario.control.guard =
      top.map("control").choice("guard") == 0 ? GuardPlace::kInline : GuardPlace::kProcess;
  scenario.record.rate = top.map("record").number_f("rate");
  scenario.world = build_world(top.map("world"), roots, findings);
  scenario.hals = build_hals(top, scenario.control.rate, findings);
  scenario.swarms = build_swarms(top, scenario, roots, findings);
  scenario.world.brushes = build_brushes(top.map("world"), scenario, findings);
  Stimuli stimuli = build_stimuli(top, scenario, findings);
  scenario.lamps = std::move(stimuli.lamps);
  scenario.stimuli = std::move(stimuli.others);
  check_pulls(scenario, findings);
  scenario.field_rate = top.map("planners").map("fields").number_f("rate");
  if (findings.errors.empty()) {
    check_memory(top.map("world"), scenario, available_memory(), findings);
  }
  scenario.faults = build_faults(top, scenario, findings);
  scenario.twins = build_twins(top, scenario, findings);
  scenario.expect = build_expectations(top, scenario, findings);
  scenario.planners = build_planners(top, findings);
  scenario.warnings = std::move(findings.warnings);
  if (!findings.errors.empty()) {
    if (findings.errors.size() > kMaxErrors) {
      findings.errors.resize(kMaxErrors);
    }
    return Failure(std::move(findings.errors));
  }
  return scenario;
}

}  // namespace

ScenarioResult load_scenario(const std::filesystem::path& file, std::span<const Override> overrides) {
  auto text = read_text_file(file);
  if (!text) {
    return failure(std::move(text.error()));
  }
  return load_scenario_text(*text, file, overrides);
}

ScenarioResult load_scenario_text(std::string_view text, const std::filesystem::path& file,
                                  std::span<const Override> overrides) {
  auto root = parse_yaml(text, file.string());
  if (!root) {
    return failure(std::move(root.error()));
  }
  const FileRoots roots = find_roots(file);
  std::vector<Error> errors = apply_overrides(*root, overrides);
  std::vector<Error> preset_errors = apply_presets(*root, roots);
  std::vector<Error> tree_errors = check_tree(*root);
  errors.insert(errors.end(), preset_errors.begin(), preset_errors.end());
  errors.insert(errors.end(), tree_errors.begin(), tree_errors.end());
  if (!errors.empty()) {
    return Failure(std::move(errors));
  }
  return build_scenario(*root, file, roots);
}

}  // namespace mayfly
