// Searches against looking at every pair.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "controller/engine/avoidance.hpp"
#include "controller/engine/nearest.hpp"
#include "controller/engine/neighbour_lists.hpp"

namespace mayfly {
namespace {

struct Cloud {
  std::vector<float> x, y, z;
  PositionColumns columns() const { return {x, y, z}; }
  void add(float px, float py, float pz) {
    x.push_back(px);
    y.push_back(py);
    z.push_back(pz);
  }
  float distance2(std::size_t a, std::size_t b) const {
    const float dx = x[b] - x[a], dy = y[b] - y[a], dz = z[b] - z[a];
    return dx * dx + dy * dy + dz * dz;
  }
};

// Even, in one knot, on a lattice (many as near as each other), in one point, far apart; some without a
// place.
Cloud cloud_of(int kind, std::size_t points) {
  Cloud cloud;
  std::mt19937 engine(static_cast<unsigned>(kind + 1));
  std::uniform_real_distribution<float> even(-3, 3);
  std::normal_distribution<float> knot(0, 0.2F);
  for (std::size_t p = 0; p < points; ++p) {
    const auto n = static_cast<float>(p);
    if (kind == 0) {
      cloud.add(even(engine), even(engine), even(engine));
    } else if (kind == 1) {
      cloud.add(5 + knot(engine), knot(engine), p % 50 == 0 ? 1e5F * knot(engine) : knot(engine));
    } else if (kind == 2) {
      cloud.add(0.5F * static_cast<float>(p % 9), 0.5F * static_cast<float>(p / 9 % 9),
                0.5F * std::floor(n / 81));
    } else if (kind == 3) {
      cloud.add(1, 1, 1);
    } else {
      cloud.add(n * 37.5F, -n * n, n * 1e3F);
    }
  }
  for (std::size_t p = 3; p < points; p += 17) {
    cloud.y[p] = std::numeric_limits<float>::quiet_NaN();
  }
  return cloud;
}

// Squared distance and number.
std::vector<std::pair<float, int>> nearest_in(const Cloud& cloud, std::size_t self,
                                              const NearestQuery& query) {
  std::vector<std::pair<float, int>> all;
  for (std::size_t q = 0; q < cloud.x.size(); ++q) {
    if (q != self && cloud.distance2(self, q) <= query.range * query.range) {
      all.emplace_back(cloud.distance2(self, q), static_cast<int>(q));
    }
  }
  std::sort(all.begin(), all.end());
  all.resize(std::min(all.size(), static_cast<std::size_t>(query.most)));
  return all;
}

class Search : public testing::TestWithParam<std::tuple<int, std::size_t>> {
 protected:
  Cloud cloud_ = cloud_of(std::get<0>(GetParam()), std::get<1>(GetParam()));
};

TEST_P(Search, ListsEverybodyWithinTheRadius) {
  const std::size_t points = cloud_.x.size();
  ThreadTeam one(1), three(3);
  NeighbourLists lists, others;
  for (const float radius : {0.0F, 0.5F, 1.1F, 100.0F}) {
    lists.find(cloud_.columns(), radius, one);
    others.find(cloud_.columns(), radius, three);
    std::size_t all = 0;
    for (std::size_t p = 0; p < points; ++p) {
      std::vector<int> expected;
      for (std::size_t q = 0; q < points; ++q) {
        if (q != p && cloud_.distance2(p, q) <= radius * radius) {
          expected.push_back(static_cast<int>(q));
        }
      }
      std::vector<int> found(lists.of(p).begin(), lists.of(p).end());
      EXPECT_TRUE(std::equal(found.begin(), found.end(), others.of(p).begin(), others.of(p).end()));
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected) << p << " " << radius;
      all += expected.size();
    }
    EXPECT_EQ(lists.size(), all);
  }
}

TEST_P(Search, FindsTheNearest) {
  const std::size_t points = cloud_.x.size();
  ThreadTeam team(1);
  NearGrid grid;
  grid.reserve(points, team.size());
  for (const float side : {0.07F, 0.4F, 2.0F}) {
    grid.sort(cloud_.columns(), side, team);
    for (const NearestQuery query : {NearestQuery{1.0F, 10}, NearestQuery{0.5F, 1}, NearestQuery{6.0F, 16}}) {
      for (std::size_t slot = 0; slot < grid.size(); ++slot) {
        const auto self = static_cast<std::size_t>(grid.id()[slot]);
        const auto expected = nearest_in(cloud_, self, query);
        std::array<int, kMostNearest> found{};
        EXPECT_TRUE(find_nearest(grid, slot, query, query.range, found));
        for (std::size_t n = 0; n < found.size(); ++n) {
          const int id = found[n] < 0 ? -1 : grid.id()[static_cast<std::size_t>(found[n])];
          EXPECT_EQ(id, n < expected.size() ? expected[n].second : -1) << self << " " << n << " " << side;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds, Search,
                         testing::Combine(testing::Range(0, 5), testing::Values(0, 1, 9, 700)));

// A tight knot and others far around it: cells that suit the one do not suit the others.
TEST(Avoidance, SeesTheNearestInAKnotAndOutsideIt) {
  Cloud cloud;
  std::mt19937 engine(1);
  std::normal_distribution<float> normal;
  for (int p = 0; p < 1600; ++p) {
    const float scale = p % 4 == 0 ? 4.0F : 0.05F;
    cloud.add(scale * normal(engine), scale * normal(engine), scale * normal(engine));
  }
  SwarmModel swarm;
  swarm.count = cloud.x.size();
  swarm.avoidance = {1, 0.01F, 1.0F, 1.0F, 3.0F, 10, 1.0F, 0};
  Avoidance avoidance;
  const std::vector<SwarmModel> swarms{swarm};
  avoidance.prepare(swarms, cloud.x.size(), 2);
  ThreadTeam team(2);
  for (int tick = 0; tick < 3; ++tick) {
    avoidance.look_round({cloud.x, cloud.y, cloud.z}, team);
    const std::span<const int> id = avoidance.id();
    for (std::size_t slot = 0; slot < avoidance.present(); ++slot) {
      const auto expected = nearest_in(cloud, static_cast<std::size_t>(id[slot]), {3.0F, 10});
      for (std::size_t n = 0; n < kMostNearest; ++n) {
        const int found = avoidance.nearest()[slot * kMostNearest + n];
        EXPECT_EQ(found < 0 ? -1 : id[static_cast<std::size_t>(found)],
                  n < expected.size() ? expected[n].second : -1);
      }
    }
  }
}

}  // namespace
}  // namespace mayfly
