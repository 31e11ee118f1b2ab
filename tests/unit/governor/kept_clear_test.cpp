// Where a robot stands that was taken out, and where it comes to rest: all others keep clear of it.
#include "controller/governor/reservation.hpp"
#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

// Robot 0 flies at 1 m/s along x. One of the places of robot `whose` lies `gap` m beyond where it would rest.
Rig meeting(float gap, std::uint32_t whose, glm::vec3 half_way) {
  Rig rig(default_config(2));
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.authority[1] = Authority::kAbsent;
  const auto rest = static_cast<float>(0.01 + stopping_distance(1.0, {4.0, 0.01, 0.0}));
  const glm::vec3 middle(rest + 0.2F + gap, 0, 0);
  rig.kept_clear = {{{0, 9, 0}, {0, 9, 0}, 1}, {middle - half_way, middle + half_way, whose}};
  rig.desire(0, {1, 0, 0});
  rig.tick();
  return rig;
}

TEST(KeptClear, APlaceFiresWhereTheStopWouldNotFit) {
  for (const glm::vec3 half_way : {glm::vec3(0.0F), glm::vec3(0, 1, 0)}) {
    const Rig near = meeting(-1e-3F, 1, half_way);
    EXPECT_LT(near.command(0).x, 1.0F);
    EXPECT_EQ(near.count(GovernorReason::kNeighbour), 1U);
    const Rig far = meeting(1e-3F, 1, half_way);
    EXPECT_EQ(far.command(0), glm::vec3(1, 0, 0));
    EXPECT_EQ(far.interventions(), 0U);
  }
}

TEST(KeptClear, ItsOwnPlaceAndNobodysAreFree) {
  for (const std::uint32_t whose : {0U, 2U, 4000000000U}) {
    EXPECT_EQ(meeting(-0.1F, whose, glm::vec3(0.0F)).interventions(), 0U) << whose;
  }
}

TEST(KeptClear, HeightsCountByTheTallerOfTheTwo) {
  for (const float height : {0.55F, 0.65F}) {
    GovernorConfig config = default_config(2);
    config.groups[0].count = 1;
    config.groups.push_back(config.groups[0]);
    config.groups[1].first = 1;
    config.groups[1].limits.downwash = 3.0F;
    Rig rig(config);
    rig.authority[1] = Authority::kAbsent;
    rig.kept_clear = {{{0, 0, height}, {0, 0, height}, 1}};
    rig.tick({0, 0, 0.01F});
    EXPECT_EQ(rig.count(GovernorReason::kNeighbour), height < 0.6F ? 1U : 0U);
  }
}

TEST(KeptClear, WhoIsTooNearMayOnlyGoAway) {
  Rig pair(default_config(2));
  pair.authority[1] = Authority::kAbsent;
  pair.kept_clear = {{{0.15F, 0, 0}, {0.15F, 0, 0}, 1}};
  EXPECT_EQ(pair.tick({0.04F, 0, 0}), glm::vec3(0.0F));
  EXPECT_EQ(pair.tick({-0.04F, 0, 0}), glm::vec3(-0.04F, 0, 0));
}

}  // namespace
}  // namespace mayfly::governor_test
