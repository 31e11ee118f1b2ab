// What a planner sees of a guard, in its own process or in another: one more HAL, and an operator's few
// words.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "controller/guard/black_box.hpp"
#include "controller/guard/guard_report.hpp"
#include "core/hal.hpp"

namespace mayfly {

// As a HAL: read() gives what the guard knows (`valid` is 1 where a robot's state is fresh in this tick),
// write() takes wishes. What the guard makes of them is its own matter.
class GuardPort : public Hal {
 public:
  // An operator's request to stop, as it stands: 0 none, 1 everybody holds, 2 or more is the emergency stop.
  // Goes past all wishes; to be repeated each tick.
  virtual void ask_to_stop(int level) noexcept = 0;
  // As Guard::set_present.
  virtual void set_present(std::span<const std::uint8_t> present) noexcept = 0;
  // An operator's acknowledge; what stays may be told later than at once, with severity().
  virtual void acknowledge() noexcept = 0;
  // The worst of all robots, now.
  virtual Severity severity() const noexcept = 0;
  // What was sent to the robots last, as far as it is known here.
  virtual CommandColumns written() const noexcept = 0;

  // How many reactions have begun so far.
  virtual std::uint64_t reactions() const noexcept = 0;

  // For the summary, when all is over.
  virtual GuardReport report() const = 0;
  virtual std::vector<GuardEvent> events() const = 0;
  // The last seconds before something went wrong first; null where nothing did, or where another keeps it.
  virtual const BlackBoxTape* tape() const noexcept { return nullptr; }
};

}  // namespace mayfly
