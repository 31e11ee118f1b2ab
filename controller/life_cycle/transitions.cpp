#include "controller/life_cycle/transitions.hpp"

namespace mayfly {
namespace {

constexpr std::array<std::string_view, kRobotStates> kStateNames = {
    "unknown", "connected", "checked", "armed", "taking off", "flying",
    "holding", "returning", "landing", "off",   "fault"};
constexpr std::array<std::string_view, kRobotEvents> kEventNames = {
    "heard",  "checks passed", "checks failed", "arm",  "disarm", "take off", "airborne", "hold",
    "resume", "return",        "arrived",       "land", "landed", "lost",     "fail",     "clear"};
constexpr std::array<std::string_view, 6> kCommandNames = {"none",     "velocity", "hold",
                                                           "take off", "land",     "stop"};

}  // namespace

std::string_view name_of(RobotState state) noexcept {
  return kStateNames[static_cast<std::size_t>(state)];
}

std::string_view name_of(RobotEvent event) noexcept {
  return kEventNames[static_cast<std::size_t>(event)];
}

std::string_view name_of(CommandKind kind) noexcept {
  return kCommandNames[static_cast<std::size_t>(kind)];
}

}  // namespace mayfly
