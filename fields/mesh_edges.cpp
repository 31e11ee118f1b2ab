#include "fields/mesh_edges.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <tuple>

#include "fields/scan_lines.hpp"

namespace mayfly::fields {
namespace {

// Sets of triangles that merge.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void merge(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// Merges what shares a crowded edge, unless each group by itself passes it as often one way as the other.
void merge_over_crowded_edge(std::span<const EdgeUse> uses, Groups& groups) {
  std::map<std::uint32_t, int> balance;
  for (const EdgeUse& use : uses) {
    balance[groups.find(use.triangle)] += use.direction;
  }
  std::uint32_t first = groups.find(uses[0].triangle);
  bool found = false;
  for (const auto& [group, sum] : balance) {
    if (sum != 0) {
      if (found) {
        groups.merge(first, group);
      }
      first = group;
      found = true;
    }
  }
}

Hole measure(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop) {
  glm::vec3 low = mesh.vertices[loop[0]];
  glm::vec3 high = low;
  for (const std::uint32_t v : loop) {
    low = glm::min(low, mesh.vertices[v]);
    high = glm::max(high, mesh.vertices[v]);
  }
  const glm::vec3 side = high - low;
  return {loop.size(), 0.5F * (low + high), std::max({side.x, side.y, side.z})};
}

double six_volumes(const TriangleMesh& mesh, const glm::uvec3& t, const glm::dvec3& about) {
  const glm::dvec3 a = glm::dvec3(mesh.vertices[t.x]) - about;
  const glm::dvec3 b = glm::dvec3(mesh.vertices[t.y]) - about;
  const glm::dvec3 c = glm::dvec3(mesh.vertices[t.z]) - about;
  return glm::dot(a, glm::cross(b, c));
}

}  // namespace

std::vector<EdgeUse> edge_uses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t from = mesh.triangles[t][corner];
      const std::uint32_t to = mesh.triangles[t][(corner + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), t, from < to ? 1 : -1});
    }
  }
  std::ranges::sort(uses, {}, [](const EdgeUse& use) { return std::tie(use.low, use.high, use.triangle); });
  return uses;
}

std::vector<Hole> find_holes(const TriangleMesh& mesh, std::span<const EdgeUse> uses) {
  std::multimap<std::uint32_t, std::uint32_t> next;  // both ways
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() % 2 == 1) {
      next.emplace(edge[0].low, edge[0].high);
      next.emplace(edge[0].high, edge[0].low);
    }
  });
  std::vector<Hole> holes;
  while (!next.empty()) {
    std::vector<std::uint32_t> loop;
    // Every vertex has an even number of such edges, so the walk ends where it began.
    for (auto edge = next.begin(); edge != next.end(); edge = next.find(loop.back())) {
      const auto [from, to] = *edge;
      next.erase(edge);
      const auto [first, last] = next.equal_range(to);
      next.erase(
          std::find_if(first, last, [&, back = from](const auto& other) { return other.second == back; }));
      loop.push_back(to);
      if (next.find(to) == next.end()) {
        break;
      }
    }
    holes.push_back(measure(mesh, loop));
  }
  std::ranges::sort(holes, std::ranges::greater{}, &Hole::width);
  return holes;
}

PartList find_parts(const TriangleMesh& mesh, std::span<const EdgeUse> uses) {
  Groups groups(mesh.triangles.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) {
      groups.merge(edge[0].triangle, edge[1].triangle);
    }
  });
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() > 2) {
      merge_over_crowded_edge(edge, groups);
    }
  });
  PartList parts;
  std::vector<std::uint32_t> names(mesh.triangles.size(), ~std::uint32_t{0});
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& name = names[groups.find(t)];
    if (name == ~std::uint32_t{0}) {
      name = static_cast<std::uint32_t>(parts.count++);
    }
    parts.of_triangle.push_back(name);
  }
  return parts;
}

std::vector<bool> find_inside_out(const TriangleMesh& mesh, const PartList& parts) {
  std::vector<double> volume(parts.count, 0.0);
  std::vector<std::uint32_t> sample(parts.count);  // any triangle of the part
  const glm::dvec3 about(mesh.vertices[0]);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    volume[parts.of_triangle[t]] += six_volumes(mesh, mesh.triangles[t], about);
    sample[parts.of_triangle[t]] = t;
  }
  std::vector<std::uint32_t> order(parts.count);
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::uint32_t p) { return std::abs(volume[p]); });
  std::vector<bool> turned(parts.count, false);
  std::vector<bool> larger(parts.count, false);  // parts that were looked at
  for (const std::uint32_t part : order) {
    if (volume[part] < 0.0) {
      const glm::uvec3& s = mesh.triangles[sample[part]];
      const glm::dvec3 at =
          (glm::dvec3(mesh.vertices[s.x]) + glm::dvec3(mesh.vertices[s.y]) + glm::dvec3(mesh.vertices[s.z])) /
          3.0;
      int winding = 0;
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t other = parts.of_triangle[t];
        if (larger[other]) {
          const glm::uvec3& i = mesh.triangles[t];
          const glm::dvec3 a(mesh.vertices[i.x]);
          const glm::dvec3 b(mesh.vertices[i.y]);
          const glm::dvec3 c(mesh.vertices[i.z]);
          const int passes = crossing(a, b, c, at.y, at.z);
          winding +=
              passes != 0 && crossing_x(a, b, c, at.y, at.z) < at.x ? (turned[other] ? -passes : passes) : 0;
        }
      }
      turned[part] = winding == 0;
    }
    larger[part] = true;
  }
  return turned;
}

}  // namespace mayfly::fields
