// What follows from a swarm's limits, worked out once.
#pragma once

#include "controller/governor/claims.hpp"
#include "controller/governor/clearance.hpp"
#include "controller/governor/governor_config.hpp"
#include "controller/governor/reference.hpp"

namespace mayfly {

struct GroupModel {
  GovernorGroup spec;
  Braking braking;
  ReferenceModel model;
  double command_life = 0.0;  // s that a command is obeyed for, at least a period
  double change_limit = 0.0;  // m/s a tick
  double kept = 0.0;          // m around a reservation: body, tube, arc and rounding
  double nudge_from = 0.0;    // m that a robot may be off its reference before that is moved
  double most_nudge = 0.0;    // m a tick
  Clearance clearance;

  // s until a robot with this velocity may be at rest.
  double rest_time(double speed) const;
  // The same from the last command on, where nothing more was heard: 95 % of a lag besides.
  double rest_time_unheard(double speed) const;
  // m from its lead: what it may need in a tick, at this speed before it.
  double reach(double speed, double tail) const;
  // The same of all that keep the speed limit.
  double usual_reach() const;
};

GroupModel make_group_model(const GovernorGroup& spec, const GovernorConfig& config);

}  // namespace mayfly
