#include "controller/flight/flight_rights.hpp"

#include <fmt/format.h>

#include <utility>

namespace mayfly {

Result<FlightRights> FlightRights::take(RealtimePolicy policy) {
  FlightRights rights(request_realtime(kControlPriority));
  if (policy == RealtimePolicy::kIgnore || rights.granted().complete()) {
    return rights;
  }
  return fail(Cause::kEnvironment,
              fmt::format("control.realtime is enforced, and this machine does not grant {}; 'ignore' flies "
                          "without, and says so",
                          fmt::join(rights.missing(), "; nor ")));
}

FlightRights::FlightRights(RealtimeRights rights) : rights_(std::move(rights)) {}

FlightRights::FlightRights(FlightRights&& other) noexcept
    : rights_(std::move(other.rights_)), held_(std::exchange(other.held_, false)) {}

FlightRights::~FlightRights() {
  if (held_) {
    drop_realtime();
  }
}

std::vector<std::string> FlightRights::missing() const {
  std::vector<std::string> missing;
  for (const RealtimeRights::Refusal& refusal : rights_.refused) {
    missing.push_back(fmt::format("{} ({}): {}", refusal.right, refusal.reason, refusal.remedy));
  }
  return missing;
}

}  // namespace mayfly
