#include "controller/guard/invariants.hpp"

namespace mayfly {
namespace {

constexpr std::string_view kNames[kInvariants] = {
    "I1 finite",     "I2 speed",        "I3 acceleration",   "I4 separation", "I5 fence",
    "I6 ages",       "I7 tracking",     "I8 sequence",       "I9 armed",      "I10 transition",
    "I11 severity",  "I12 tick_budget", "I13 no_allocation", "I14 decodes",   "I15 units",
    "I16 one_owner", "I17 heartbeat"};

}  // namespace

std::string_view name_of(Invariant invariant) noexcept {
  return kNames[static_cast<std::size_t>(invariant)];
}

std::string_view key_of(Invariant invariant) noexcept {
  const std::string_view name = name_of(invariant);
  return name.substr(name.find(' ') + 1);
}

Symptom symptom_of(Invariant invariant) noexcept {
  switch (invariant) {
    case Invariant::kFinite:
    case Invariant::kSpeed:
    case Invariant::kAcceleration:
      return Symptom::kLimitBroken;
    case Invariant::kSeparation:
      return Symptom::kTooNear;
    case Invariant::kFence:
      return Symptom::kOutOfFence;
    case Invariant::kTracking:
      return Symptom::kTrackingError;
    case Invariant::kTickBudget:
      return Symptom::kTickLate;
    default:
      return Symptom::kInvariantBroken;
  }
}

}  // namespace mayfly
