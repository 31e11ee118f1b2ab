// From the strongest word to the weakest: absent, cut, landing, silent, holding, the planner's wish. In every
// state, at every severity.
#include "controller/guard/orders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <map>

#include "tests/unit/guard/wish.hpp"

namespace mayfly::test {
namespace {

// The events that lead from nothing to each state, shortest first.
std::map<RobotState, std::vector<RobotEvent>> ways() {
  std::map<RobotState, std::vector<RobotEvent>> found{{RobotState::kUnknown, {}}};
  std::deque<RobotState> open{RobotState::kUnknown};
  for (; !open.empty(); open.pop_front()) {
    for (std::size_t e = 0; e < kRobotEvents; ++e) {
      const auto event = static_cast<RobotEvent>(e);
      const auto next = next_state(open.front(), event);
      if (next && !found.contains(*next)) {
        found[*next] = found[open.front()];
        found[*next].push_back(event);
        open.push_back(*next);
      }
    }
  }
  return found;
}

// One robot in the air, at (5, 5, 5); a wish of (1, 0, 0).
struct Desk {
  explicit Desk(RobotState state) : desk(1, 5 * kTick), lives(LifeCycleConfig{.robots = 1}) {
    Observation seen;
    seen.now = kTick;
    lives.observe(0, seen);  // in the air
    while (lives.state(0) != RobotState::kUnknown) {
      lives.request(0, lives.state(0) == RobotState::kConnected ? RobotEvent::kLost : RobotEvent::kClear);
    }
    static const auto kWays = ways();
    for (const RobotEvent event : kWays.at(state)) {
      lives.request(0, event);
    }
    EXPECT_EQ(lives.state(0), state);
    wished.kind[0] = CommandKind::kVelocity;
  }

  void give() {
    desk.judge(kTick, wished.columns(3 * kTick, ++sequence));
    const Orders::Tick tick{desk,     lives,   severity,
                            symptoms, present, {x, x, x, v, v, v, stamp, known, none, none_of_all, {}}};
    orders.give(tick);
    kind[0] = orders.authority()[0] == Authority::kGoverned ? CommandKind::kVelocity : CommandKind::kHold;
    vx[0] = std::isfinite(orders.desired().vx[0]) ? orders.desired().vx[0] : 0.0F;
    vz[0] = std::isfinite(orders.desired().vz[0]) ? orders.desired().vz[0] : 0.0F;
    orders.finish({kind, vx, vy, vz, {}});
  }

  WishDesk desk;
  LifeCycles lives;
  WishOf wished{1, {1, 0, 0}};
  Orders orders{{.robots = 1, .descent = 0.5F, .homing = 0.5F, .floor = {0.4F}}};
  std::vector<Severity> severity{Severity::kNone};
  std::vector<Symptoms> symptoms{Symptoms{}}, none{Symptoms{}};
  Symptoms none_of_all;
  std::vector<std::uint8_t> present, known{1};
  std::vector<float> x{5.0F}, v{0.0F};
  std::vector<Time> stamp{kTick};
  std::vector<CommandKind> kind{CommandKind::kNone};
  std::vector<float> vx{0.0F}, vy{0.0F}, vz{0.0F};
  std::uint64_t sequence = 0;
};

enum class Word { kAbsent, kCut, kLanding, kSilent, kHolding, kWish };

// The strongest that is said.
Word strongest(RobotState state, Severity severity, bool present, bool silent) {
  if (!present) {
    return Word::kAbsent;
  }
  if (severity >= Severity::kCut) {
    return Word::kCut;
  }
  if (!is_armed(state)) {
    return Word::kWish;
  }
  if (severity >= Severity::kLand || state == RobotState::kLanding) {
    return Word::kLanding;
  }
  if (severity < Severity::kHold) {
    return Word::kWish;
  }
  return silent ? Word::kSilent : Word::kHolding;
}

void expect_word(const Desk& desk, Word word, RobotState state) {
  const Authority authority = desk.orders.authority()[0];
  const CommandKind kind = desk.kind[0];
  switch (word) {
    case Word::kAbsent:
      EXPECT_EQ(authority, Authority::kAbsent);
      EXPECT_EQ(kind, CommandKind::kHold);
      EXPECT_EQ(desk.orders.ours()[0], 0);
      break;
    case Word::kCut:
      EXPECT_EQ(kind, CommandKind::kStop);
      EXPECT_EQ(desk.orders.ours()[0], 0);
      break;
    case Word::kLanding:
      EXPECT_LT(desk.orders.desired().vz[0], 0.0F) << "it is brought down";
      EXPECT_EQ(desk.orders.desired().vx[0], 0.0F);
      break;
    case Word::kSilent:
      EXPECT_EQ(authority, Authority::kSilent);
      EXPECT_EQ(kind, CommandKind::kHold);
      break;
    case Word::kHolding:
      EXPECT_EQ(authority, Authority::kBraking);
      EXPECT_EQ(kind, CommandKind::kHold);
      break;
    case Word::kWish:
      EXPECT_EQ(desk.orders.desired().vx[0] == 1.0F, state == RobotState::kFlying);
      EXPECT_EQ(kind == CommandKind::kVelocity, state == RobotState::kFlying);
      break;
  }
}

void try_word(RobotState state, Severity severity, bool present, bool silent) {
  SCOPED_TRACE(std::string(name_of(state)) + " at severity " + std::to_string(static_cast<int>(severity)) +
               (present ? "" : ", absent") + (silent ? ", silent" : ""));
  Desk desk(state);
  desk.severity[0] = severity;
  desk.present = {static_cast<std::uint8_t>(present ? 1 : 0)};
  if (silent) {
    desk.symptoms[0].add(Symptom::kSilent);
  }
  desk.give();
  expect_word(desk, strongest(state, severity, present, silent), state);
}

TEST(Orders, TheStrongestWordCountsInEveryStateAtEverySeverity) {
  for (std::size_t state = 0; state < kRobotStates; ++state) {
    for (std::size_t severity = 0; severity < kSeverities; ++severity) {
      for (const int said : {0, 1, 2, 3}) {
        try_word(static_cast<RobotState>(state), static_cast<Severity>(severity), said % 2 == 0,
                 said / 2 == 1);
      }
    }
  }
}

TEST(Orders, AnEmptyColumnMeansThatAllAreThere) {
  Desk desk(RobotState::kFlying);
  desk.give();
  expect_word(desk, Word::kWish, RobotState::kFlying);
}

TEST(Orders, ABadLinkHalvesWhatIsWished) {
  Desk desk(RobotState::kFlying);
  desk.symptoms[0].add(Symptom::kLinkDegraded);
  desk.severity[0] = Severity::kReport;
  desk.give();
  EXPECT_EQ(desk.orders.desired().vx[0], 1.0F) << "not yet";
  desk.severity[0] = Severity::kClamp;
  desk.give();
  EXPECT_EQ(desk.orders.desired().vx[0], 0.5F);
}

TEST(Orders, OneThatReturnsGoesBackToWhereItWasArmed) {
  Desk desk(RobotState::kFlying);
  desk.give();  // here is home
  desk.lives.request(0, RobotEvent::kReturn);
  desk.orders.send_home(0);
  desk.x[0] = 6.0F;
  desk.give();
  EXPECT_LT(desk.orders.desired().vx[0], 0.0F);
  const float speed = std::sqrt(3.0F) * std::fabs(desk.orders.desired().vx[0]);
  EXPECT_NEAR(speed, 0.5F, 1e-5F);
  desk.known[0] = 0;
  desk.give();
  EXPECT_EQ(desk.orders.authority()[0], Authority::kBraking) << "nobody knows the way";
  desk.known[0] = 1;
  desk.x[0] = 5.01F;
  desk.v[0] = 0.05F;
  desk.give();
  EXPECT_EQ(desk.lives.state(0), RobotState::kReturning) << "too fast";
  desk.v[0] = 0.0F;
  desk.x[0] = 5.02F;
  desk.give();
  EXPECT_EQ(desk.lives.state(0), RobotState::kReturning) << "not there yet";
  desk.x[0] = 5.01F;
  desk.give();
  EXPECT_EQ(desk.lives.state(0), RobotState::kLanding);
}

TEST(Orders, OneThatIsSentToAPlaceHoldsThere) {
  Desk desk(RobotState::kFlying);
  desk.give();
  desk.lives.request(0, RobotEvent::kReturn);
  desk.orders.send_to(0, {6, 6, 6});
  desk.give();
  EXPECT_GT(desk.orders.desired().vx[0], 0.0F);
  desk.x[0] = 6.0F;
  desk.give();
  EXPECT_EQ(desk.lives.state(0), RobotState::kHolding);
}

}  // namespace
}  // namespace mayfly::test
