// Robots that somebody else flies for: what the guard has to know of it.
#pragma once

#include <span>

#include "controller/governor/governor_columns.hpp"
#include "core/clock.hpp"

namespace mayfly {

class Guard;

// Takes robots out of a run and puts them back (controller/twin/twin_exchange.hpp). Called in the tick:
// allocates, blocks and throws nothing.
class Exchange {
 public:
  Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  virtual ~Exchange() = default;

  // Before the robots are heard; may ask `guard` to lead one of them.
  virtual void tick(Time now, Guard& guard) noexcept = 0;
  // Once they were heard: the places of those that are out, which all others keep clear of.
  virtual std::span<const KeptClear> kept_clear() noexcept = 0;
};

}  // namespace mayfly
