// The table of a robot's life: every transition, every refusal, and what follows from it as a whole.
#include "controller/life_cycle/transitions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "controller/life_cycle/life_cycle.hpp"

namespace mayfly {
namespace {

constexpr std::string_view kLetters = "UCKATFHRLOX";  // of the states, in their order; X is fault

// Written down again, by hand. A row for each state; a column for each event: heard, checks passed, checks
// failed, arm, disarm, take off, airborne, hold, resume, return, arrived, land, landed, lost, fail, clear.
constexpr std::array<std::string_view, kRobotStates> kExpected = {
    "C.............X.",  // unknown
    ".K...........UX.",  // connected
    "..CA.........UX.",  // checked
    "..C.KTF......XX.",  // armed
    "......FH...L.XX.",  // taking off
    ".......H.R.LOXX.",  // flying
    "........FR.LOXX.",  // holding
    ".......HF.HLOXX.",  // returning
    "............OXX.",  // landing
    "..............XU",  // off
    "...............U",  // fault
};

std::vector<RobotState> all_states() {
  std::vector<RobotState> all;
  for (std::size_t s = 0; s < kRobotStates; ++s) {
    all.push_back(static_cast<RobotState>(s));
  }
  return all;
}

std::vector<RobotEvent> all_events() {
  std::vector<RobotEvent> all;
  for (std::size_t e = 0; e < kRobotEvents; ++e) {
    all.push_back(static_cast<RobotEvent>(e));
  }
  return all;
}

// Where the hand-written table leads; nothing where it refuses.
std::optional<RobotState> expected(RobotState state, RobotEvent event) {
  const char letter = kExpected[static_cast<std::size_t>(state)][static_cast<std::size_t>(event)];
  return letter == '.' ? std::nullopt : std::optional(static_cast<RobotState>(kLetters.find(letter)));
}

// The events that take a robot from unknown to a state.
std::vector<RobotEvent> way_to(RobotState state) {
  using E = RobotEvent;
  static const std::array<std::vector<RobotEvent>, kRobotStates> kWays = {{
      {},
      {E::kHeard},
      {E::kHeard, E::kChecksPassed},
      {E::kHeard, E::kChecksPassed, E::kArm},
      {E::kHeard, E::kChecksPassed, E::kArm, E::kTakeOff},
      {E::kHeard, E::kChecksPassed, E::kArm, E::kTakeOff, E::kAirborne},
      {E::kHeard, E::kChecksPassed, E::kArm, E::kAirborne, E::kHold},
      {E::kHeard, E::kChecksPassed, E::kArm, E::kAirborne, E::kReturn},
      {E::kHeard, E::kChecksPassed, E::kArm, E::kAirborne, E::kLand},
      {E::kHeard, E::kChecksPassed, E::kArm, E::kAirborne, E::kLand, E::kLanded},
      {E::kFail},
  }};
  return kWays[static_cast<std::size_t>(state)];
}

TEST(Transitions, EveryPairOfStateAndEventIsAsWrittenDown) {
  for (const RobotState state : all_states()) {
    for (const RobotEvent event : all_events()) {
      EXPECT_EQ(next_state(state, event), expected(state, event)) << name_of(state) << ", " << name_of(event);
    }
  }
}

TEST(Transitions, EveryPairIsDoneOrRefusedAndCountedInALife) {
  for (const RobotState state : all_states()) {
    for (const RobotEvent event : all_events()) {
      LifeCycles lives({.robots = 1});
      for (const RobotEvent step : way_to(state)) {
        ASSERT_TRUE(lives.request(0, step));
      }
      ASSERT_EQ(lives.state(0), state);
      const std::uint64_t accepted = lives.counters().accepted;
      const std::optional<RobotState> next = expected(state, event);
      EXPECT_EQ(lives.request(0, event), next.has_value()) << name_of(state) << ", " << name_of(event);
      EXPECT_EQ(lives.state(0), next.value_or(state));
      EXPECT_EQ(lives.counters().accepted, accepted + (next ? 1 : 0));
      EXPECT_EQ(lives.counters().refused, next ? 0U : 1U);
      EXPECT_EQ(lives.counters().refused_by_event[static_cast<std::size_t>(event)], next ? 0U : 1U);
    }
  }
}

TEST(Transitions, AreListedOnce) {
  std::set<std::pair<RobotState, RobotEvent>> pairs;
  for (const Transition& t : life_cycle::kTransitions) {
    EXPECT_TRUE(pairs.insert({t.from, t.event}).second) << name_of(t.from) << ", " << name_of(t.event);
    EXPECT_NE(t.from, t.to) << "a transition that leads nowhere";
  }
}

std::set<RobotState> reachable_from(RobotState state) {
  std::set<RobotState> reached{state};
  for (bool grew = true; grew;) {
    const std::size_t before = reached.size();
    for (const Transition& t : life_cycle::kTransitions) {
      if (reached.contains(t.from)) {
        reached.insert(t.to);
      }
    }
    grew = reached.size() > before;
  }
  return reached;
}

TEST(Transitions, EveryStateIsReachedAndLeadsToAnEnd) {
  EXPECT_EQ(reachable_from(RobotState::kUnknown).size(), kRobotStates);
  for (const RobotState state : all_states()) {
    const std::set<RobotState> reached = reachable_from(state);
    EXPECT_TRUE(reached.contains(RobotState::kOff) || reached.contains(RobotState::kFault)) << name_of(state);
  }
}

TEST(Transitions, FaultIsLeftByAnOperatorAlone) {
  for (const RobotEvent event : all_events()) {
    EXPECT_EQ(next_state(RobotState::kFault, event).has_value(), event == RobotEvent::kClear)
        << name_of(event);
  }
}

TEST(Transitions, AnyRobotMayFail) {
  for (const RobotState state : all_states()) {
    EXPECT_EQ(next_state(state, RobotEvent::kFail).has_value(), state != RobotState::kFault);
  }
}

// To fly a robot has to pass its checks and be armed, whatever the order of events.
TEST(Transitions, NobodyFliesUnchecked) {
  for (const Transition& t : life_cycle::kTransitions) {
    const bool moves = t.to == RobotState::kTakingOff || t.to == RobotState::kFlying ||
                       t.to == RobotState::kHolding || t.to == RobotState::kReturning;
    if (moves) {
      EXPECT_GE(t.from, RobotState::kArmed);
      EXPECT_LE(t.from, RobotState::kReturning);
    }
    if (t.to == RobotState::kArmed) {
      EXPECT_EQ(t.from, RobotState::kChecked);
    }
  }
}

// none, velocity, hold, take off, land, stop; then what is sent on the ground and in the air.
struct Orders {
  std::string_view allowed;
  CommandKind on_ground, in_air;
};
constexpr std::array<Orders, kRobotStates> kOrders = {{
    {"n.h..s", CommandKind::kNone, CommandKind::kHold},
    {"n.h..s", CommandKind::kNone, CommandKind::kHold},
    {"n.h..s", CommandKind::kNone, CommandKind::kHold},
    {"n.ht.s", CommandKind::kNone, CommandKind::kHold},
    {"n..tls", CommandKind::kTakeOff, CommandKind::kTakeOff},
    {"nvh.ls", CommandKind::kHold, CommandKind::kHold},
    {"n.h.ls", CommandKind::kHold, CommandKind::kHold},
    {"n...ls", CommandKind::kHold, CommandKind::kVelocity},
    {"n...ls", CommandKind::kLand, CommandKind::kLand},
    {"n....s", CommandKind::kStop, CommandKind::kStop},
    {"n.h.ls", CommandKind::kStop, CommandKind::kHold},
}};

TEST(Orders, EveryCommandInEveryStateIsAsWrittenDown) {
  for (const RobotState state : all_states()) {
    const Orders& orders = kOrders[static_cast<std::size_t>(state)];
    for (std::size_t kind = 0; kind < 6; ++kind) {
      EXPECT_EQ(allows(state, static_cast<CommandKind>(kind)), orders.allowed[kind] != '.')
          << name_of(state) << ", " << name_of(static_cast<CommandKind>(kind));
    }
    EXPECT_EQ(own_command(state, false), orders.on_ground) << name_of(state);
    EXPECT_EQ(own_command(state, true), orders.in_air) << name_of(state);
  }
}

TEST(Orders, OnlyWhoFliesIsSentAPlannersVelocity) {
  for (const RobotState state : all_states()) {
    EXPECT_EQ(allows(state, CommandKind::kVelocity), state == RobotState::kFlying) << name_of(state);
  }
}

TEST(Orders, StoppingIsNeverRefused) {
  for (const RobotState state : all_states()) {
    EXPECT_TRUE(allows(state, CommandKind::kStop));
  }
}

}  // namespace
}  // namespace mayfly
