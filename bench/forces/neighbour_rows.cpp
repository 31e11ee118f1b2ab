// Who is within a radius: exact lists of all points, the search structure's building included, beside
// nanoflann.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nanoflann.hpp>
#include <numbers>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/common/least_seconds.hpp"
#include "bench/forces/crowd.hpp"
#include "bench/forces/measure.hpp"
#include "controller/engine/neighbour_lists.hpp"

namespace mayfly::bench {
namespace {

constexpr std::size_t kPoints = 100'000;
constexpr double kNeighbours = 29.0;  // of each, in the mean
constexpr float kRadius = 1.0F;       // m
constexpr int kRepeats = 3;

// What nanoflann asks of a cloud.
class Cloud {
 public:
  explicit Cloud(const std::vector<glm::vec3>& points) : points_(points) {}

  std::size_t kdtree_get_point_count() const { return points_.size(); }
  float kdtree_get_pt(std::size_t point, std::size_t axis) const {
    return points_[point][static_cast<int>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }

 private:
  const std::vector<glm::vec3>& points_;
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t>;

// Makes the lists of the points [first, last).
void search(const Tree& tree, const std::vector<glm::vec3>& points, std::size_t first, std::size_t last) {
  std::vector<std::pair<std::uint32_t, float>> found;
  for (std::size_t p = first; p < last; ++p) {
    const std::array query{points[p].x, points[p].y, points[p].z};
    tree.radiusSearch(query.data(), kRadius * kRadius, found, {32, 0.0F, false});
  }
}

// s for the lists of all points on `threads` threads. The tree is built on one: it knows no other way.
double nanoflann_seconds(const std::vector<glm::vec3>& points, int threads) {
  return least_seconds(kRepeats, [&](int) {
    const Cloud cloud(points);
    const Tree tree(3, cloud, {10});
    const auto parts = static_cast<std::size_t>(threads);
    std::vector<std::jthread> team;
    for (std::size_t t = 0; t < parts; ++t) {
      team.emplace_back(
          [&, t] { search(tree, points, points.size() * t / parts, points.size() * (t + 1) / parts); });
    }
  });
}

// s for the same lists by the product's own search.
double own_seconds(const std::vector<glm::vec3>& points, int threads) {
  std::array<std::vector<float>, 3> columns;
  for (const glm::vec3 point : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns[axis].push_back(point[static_cast<int>(axis)]);
    }
  }
  ThreadTeam team(threads);
  NeighbourLists lists;
  return least_seconds(4 * kRepeats, [&](int) {
    lists.find({columns[0], columns[1], columns[2]}, kRadius, team);
  });
}

std::vector<glm::vec3> points_of(std::size_t count) {
  const double ball = 4.0 / 3.0 * std::numbers::pi * std::pow(static_cast<double>(kRadius), 3.0);
  return strewn_in_box(
      count, glm::vec3(static_cast<float>(std::cbrt(static_cast<double>(count) * ball / kNeighbours))));
}

}  // namespace

Result<void> measure_neighbour_rows(const ForcesPlan& plan, Report& report) {
  Curve curve{"neighbours", "Neighbours in a radius, 29 each", "points", "ns a query", {}};
  std::vector<glm::dvec2> own, peer;
  const std::size_t most = plan.at_most(kPoints);
  for (const std::size_t count : {most / 100, most / 10, most}) {
    const std::vector<glm::vec3> points = points_of(count);
    const double each = 1e9 / static_cast<double>(std::max<std::size_t>(count, 1));
    own.emplace_back(static_cast<double>(count), each * own_seconds(points, plan.threads));
    peer.emplace_back(static_cast<double>(count), each * nanoflann_seconds(points, plan.threads));
  }
  report.rows.push_back({.key = "neighbours",
                         .what = "lists of all neighbours of " + std::to_string(most) + " points, a query",
                         .value = own.back().y,
                         .unit = "ns",
                         .wanted = 250.0,
                         .baseline = "nanoflann",
                         .baseline_value = peer.back().y});
  curve.lines.emplace_back("mayfly", std::move(own));
  curve.lines.emplace_back("nanoflann", std::move(peer));
  report.curves.push_back(std::move(curve));
  return {};
}

}  // namespace mayfly::bench
