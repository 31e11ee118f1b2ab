#include "kernels/orca.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reference/orca_reference.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly::kernels {
namespace {

using reference::HalfSpace;
using reference::Vec;
using test::all_lanes;
using test::lane;
using test::Points;

constexpr float kHorizon = 2.0F;
constexpr float kPeriod = 0.05F;

MfEncounter encounter(const reference::Pair& pair, int self = 0, int other = 1) {
  MfEncounter e;
  e.line = all_lanes(pair.line);
  e.approach = mf3_sub(all_lanes(pair.own), all_lanes(pair.other));
  e.radius = mf_splat(static_cast<float>(pair.radius));
  e.parting = mf_parting(mf_isplat(self), mf_isplat(other));
  return e;
}

MfPlane half_space(const reference::Pair& pair, float share) {
  const MfEncounter e = encounter(pair);
  return mf_orca_plane(all_lanes(pair.own), &e, mf_splat(share), mf_splat(kHorizon), kPeriod);
}

TEST(HalfSpace, OfTenThousandPairsIsTheReferences) {
  Points lines(1.5);
  Points velocities(1.5, 2);
  double worst = 0;
  int overlapping = 0;
  for (int n = 0; n < 10000; ++n) {
    const float share = n % 3 == 0 ? 1.0F : 0.5F;
    const reference::Pair pair{lines.next(), velocities.next(), velocities.next(), 0.125 + n % 7 * 0.125};
    overlapping += reference::norm(pair.line) < pair.radius ? 1 : 0;
    const HalfSpace expected = reference::orca_half_space(pair, share, double{kHorizon}, double{kPeriod});
    const MfPlane p = half_space(pair, share);
    worst = std::max(worst, reference::norm(lane(p.n) - expected.n));
    worst = std::max(worst, std::fabs(double{p.d[0]} - expected.d) / std::max(1.0, std::fabs(expected.d)));
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_GT(overlapping, 200);
}

// Both take half: whatever the two then choose, their relative velocity leaves the obstacle.
TEST(HalfSpace, OfTheTwoOfAPairAreOpposite) {
  Points points(1.5);
  for (int n = 0; n < 500; ++n) {
    reference::Pair pair{points.next(), points.next(), points.next(), 0.5};
    if (n % 10 == 0) {
      pair.own = pair.other;  // no relative velocity
    }
    if (n % 20 == 0) {
      pair.line = {0, 0, 0};  // nor a line
    }
    if (n % 10 == 1) {
      pair.own = pair.other + pair.line * 2.0;  // straight at it
    }
    const reference::Pair back{pair.line * -1.0, pair.other, pair.own, pair.radius};
    const MfEncounter there = encounter(pair, 3, 8);
    const MfEncounter home = encounter(back, 8, 3);
    const MfEscape a = mf_escape(&there, mf_splat(kHorizon), kPeriod);
    const MfEscape b = mf_escape(&home, mf_splat(kHorizon), kPeriod);
    EXPECT_LT(reference::norm(lane(a.n) + lane(b.n)), 2e-6) << n;
    EXPECT_NEAR(reference::norm(lane(a.n)), 1, 2e-6) << n;
    EXPECT_NEAR(a.change[0], b.change[0], 1e-6 * (1 + std::fabs(a.change[0]))) << n;
  }
}

struct Problem {
  std::vector<HalfSpace> planes;
  std::size_t hard = 0;
  Vec wish{};
  double most = 1;
};

// Random half-spaces: most of them leave zero free, some do not.
Problem random_problem(std::mt19937& engine, int planes, double low) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> offset(low, 0.25);
  Problem problem;
  const auto draw = [&] { return Vec{normal(engine), normal(engine), normal(engine)}; };
  for (int p = 0; p < planes; ++p) {
    problem.planes.push_back({reference::unit(draw()), offset(engine)});
  }
  problem.wish = draw() * 0.6;
  return problem;
}

struct Solution {
  Vec v;
  bool feasible;
};

// Each lane is another problem.
std::vector<Solution> solve(const std::vector<Problem>& problems) {
  MfPlanes planes{};
  planes.firm = planes.hard = static_cast<int>(problems[0].hard);
  planes.count = static_cast<int>(problems[0].planes.size());
  F3 wish{};
  for (int k = 0; k < MF_LANES; ++k) {
    const Problem& problem = problems[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < problem.planes.size(); ++i) {
      const HalfSpace& p = problem.planes[i];
      planes.plane[i].n.x[k] = static_cast<float>(p.n[0]);
      planes.plane[i].n.y[k] = static_cast<float>(p.n[1]);
      planes.plane[i].n.z[k] = static_cast<float>(p.n[2]);
      planes.plane[i].d[k] = static_cast<float>(p.d);
    }
    wish.x[k] = static_cast<float>(problem.wish[0]);
    wish.y[k] = static_cast<float>(problem.wish[1]);
    wish.z[k] = static_cast<float>(problem.wish[2]);
  }
  const MfGoal goal = {wish, 0, mf_splat(static_cast<float>(problems[0].most)), mf_splat(1e-5F)};
  I fails;
  const F3 best = mf_best_in_space(&planes, planes.count, &goal, mf_isplat(-1), &fails);
  const F3 v = mf_least_violation(&planes, best, fails, goal.most, goal.slack);
  std::vector<Solution> solutions;
  for (int k = 0; k < MF_LANES; ++k) {
    solutions.push_back({lane(v, k), fails[k] == planes.count});
  }
  return solutions;
}

// With each half-space moved inwards (m/s).
reference::BestVelocity narrowed(const Problem& problem, double by) {
  std::vector<HalfSpace> planes = problem.planes;
  for (HalfSpace& p : planes) {
    p.d += by;
  }
  return {planes, problem.most - by};
}

constexpr double kRounding = 2e-4;  // m/s

void expect_best(const Problem& problem, const Solution& found, int* infeasible) {
  const reference::BestVelocity reference(problem.planes, problem.most);
  EXPECT_LE(reference::norm(found.v), problem.most + kRounding);
  if (found.feasible) {
    EXPECT_LT(reference.violation(found.v, 0), kRounding);
    if (const auto best = reference.nearest(problem.wish, 1e-9)) {
      EXPECT_NEAR(reference::norm(found.v - problem.wish), reference::norm(*best - problem.wish), kRounding);
    }
    return;
  }
  ++*infeasible;
  EXPECT_FALSE(narrowed(problem, 1e-3).nearest(problem.wish, 1e-9));
  EXPECT_LE(reference.violation(found.v, problem.hard), reference.least_violation(problem.hard) + kRounding);
  for (std::size_t i = 0; i < problem.hard; ++i) {
    EXPECT_GE(reference::dot(problem.planes[i].n, found.v), problem.planes[i].d - kRounding);
  }
}

TEST(Programme, FindsTheBestVelocityOrTheLeastViolation) {
  std::mt19937 engine(5);
  int infeasible = 0;
  int all = 0;
  for (const int planes : {0, 1, 2, 3, 5, 8, 12}) {
    for (int round = 0; round < (planes < 8 ? 40 : 12); ++round) {
      std::vector<Problem> problems;
      for (int k = 0; k < MF_LANES; ++k) {
        problems.push_back(random_problem(engine, planes, round % 2 == 0 ? -0.6 : -0.1));
      }
      const std::vector<Solution> found = solve(problems);
      for (std::size_t k = 0; k < MF_LANES; ++k) {
        expect_best(problems[k], found[k], &infeasible);
        ++all;
      }
    }
  }
  EXPECT_GT(infeasible, all / 10);
  EXPECT_LT(infeasible, all / 2);
}

// A corner of three walls that leaves room, and neighbours that leave none.
TEST(Programme, KeepsHardHalfSpacesWhereOthersCannotBeKept) {
  std::mt19937 engine(6);
  int infeasible = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<Problem> problems;
    for (int k = 0; k < MF_LANES; ++k) {
      Problem problem = random_problem(engine, 8, 0.0);
      problem.planes.insert(problem.planes.begin(),
                            {{{1, 0, 0}, -0.1}, {{0, -1, 0}, 0.05}, {{0, 0, 1}, -0.3}});
      problem.hard = 3;
      problems.push_back(problem);
    }
    const std::vector<Solution> found = solve(problems);
    for (std::size_t k = 0; k < MF_LANES; ++k) {
      expect_best(problems[k], found[k], &infeasible);
    }
  }
  EXPECT_GT(infeasible, 100);
}

// The same twice, nearly the same, opposite, and touching in one line or point only.
TEST(Programme, TakesHalfSpacesThatAreParallel) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> gap(-0.05, 0.3);
  int infeasible = 0;
  for (int round = 0; round < 100; ++round) {
    std::vector<Problem> problems;
    for (int k = 0; k < MF_LANES; ++k) {
      Problem problem = random_problem(engine, 3, -0.4);
      const HalfSpace p = problem.planes[0];
      const HalfSpace q = problem.planes[1];
      problem.planes.push_back(p);
      problem.planes.push_back({p.n * -1.0, -p.d - gap(engine)});
      problem.planes.push_back({reference::unit(p.n + q.n), (p.d + q.d) / reference::norm(p.n + q.n)});
      problem.planes.push_back({reference::unit(q.n + Vec{1e-5, -1e-5, 1e-5}), q.d});
      problems.push_back(problem);
    }
    const std::vector<Solution> found = solve(problems);
    for (std::size_t k = 0; k < MF_LANES; ++k) {
      expect_best(problems[k], found[k], &infeasible);
    }
  }
  EXPECT_GT(infeasible, 50);
}

}  // namespace
}  // namespace mayfly::kernels
