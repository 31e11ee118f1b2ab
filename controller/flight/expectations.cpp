#include "controller/flight/expectations.hpp"

#include <fmt/format.h>

namespace mayfly {
namespace {

using Quantity = Expectation::Quantity;
using Comparison = Expectation::Comparison;

template <class Number>
std::optional<double> as_double(const std::optional<Number>& value) {
  return value ? std::optional<double>(static_cast<double>(*value)) : std::nullopt;
}

std::optional<double> measured(const Expectation& expectation, const Summary& summary,
                               const ReachedFraction& reached, const std::optional<double>& asked) {
  switch (expectation.quantity) {
    case Quantity::kReached:
      return reached(expectation.swarm);
    case Quantity::kMinSeparation:
      return summary.min_separation_m;
    case Quantity::kPenetrations:
      return as_double(summary.penetrations);
    case Quantity::kCollisions:
      return as_double(summary.collisions);
    case Quantity::kMdePercent:
      return summary.mde_percent;
    case Quantity::kMaxSpeed:
      return summary.max_speed_mps;
    case Quantity::kMaxAcceleration:
      return summary.max_acceleration_mps2;
    case Quantity::kGovernorInterventions:
      return static_cast<double>(summary.governor_interventions);
    case Quantity::kMissed:
      return static_cast<double>(summary.control.missed);
    case Quantity::kFaults:
      return static_cast<double>(summary.faults.size());
    case Quantity::kFieldAge:
      return summary.fields && summary.fields->age_s ? std::optional(summary.fields->age_s->max)
                                                     : std::nullopt;
    case Quantity::kWallClearance:
    case Quantity::kCentreDrift:
    case Quantity::kGoalDistance:
    case Quantity::kTurns:
    case Quantity::kSpread:
    case Quantity::kPolarisation:
    case Quantity::kMilling:
    case Quantity::kNearest:
    case Quantity::kStimulusDistance:
    case Quantity::kArrived:
    case Quantity::kClearing:
    case Quantity::kParting:
    case Quantity::kClosing:
    case Quantity::kNoticed:
    case Quantity::kInfeasible:
    case Quantity::kReacted:
      return asked;
    case Quantity::kSafetyBreaches:
      return summary.safety.breaches ? std::optional(static_cast<double>(summary.safety.breaches->all()))
                                     : std::nullopt;
  }
  return std::nullopt;
}

// Written so that a NaN passes nothing.
bool holds(Comparison comparison, double value, double wanted) {
  switch (comparison) {
    case Comparison::kGreaterEqual:
      return value >= wanted;
    case Comparison::kLessEqual:
      return value <= wanted;
    case Comparison::kEqual:
      return value == wanted;
    case Comparison::kGreater:
      return value > wanted;
    case Comparison::kLess:
      return value < wanted;
  }
  return false;
}

std::string_view sign_of(Comparison comparison) {
  switch (comparison) {
    case Comparison::kGreaterEqual:
      return ">=";
    case Comparison::kLessEqual:
      return "<=";
    case Comparison::kEqual:
      return "==";
    case Comparison::kGreater:
      return ">";
    case Comparison::kLess:
      return "<";
  }
  return "";
}

}  // namespace

std::vector<ExpectationResult> hold_expectations(const std::vector<Expectation>& expectations,
                                                 const Summary& summary, const ReachedFraction& reached,
                                                 std::span<const std::optional<double>> asked) {
  std::vector<ExpectationResult> results;
  for (std::size_t i = 0; i < expectations.size(); ++i) {
    const Expectation& expectation = expectations[i];
    ExpectationResult result;
    result.name = expectation.text;
    result.value = measured(expectation, summary, reached, i < asked.size() ? asked[i] : std::nullopt);
    result.wanted = fmt::format("{} {:g}", sign_of(expectation.comparison), expectation.wanted);
    result.pass = result.value && holds(expectation.comparison, *result.value, expectation.wanted);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace mayfly
