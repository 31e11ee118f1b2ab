#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <sstream>

#include "fields/mesh.hpp"
#include "fields/mesh_edges.hpp"

namespace mayfly::fields {
namespace {

bool runs_both_ways(std::span<const EdgeUse> edge) {
  return std::accumulate(edge.begin(), edge.end(), 0,
                         [](int sum, const EdgeUse& use) { return sum + use.direction; }) == 0;
}

std::size_t inconsistent_edges(std::span<const EdgeUse> uses) {
  std::size_t count = 0;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    count += edge.size() % 2 == 0 && !runs_both_ways(edge) ? 1 : 0;
  });
  return count;
}

void flip(glm::uvec3& triangle) {
  std::swap(triangle.y, triangle.z);
}

// The other triangle over each of a triangle's edges that exactly two share, and whether the two agree on the
// winding.
struct Neighbour {
  std::uint32_t triangle;
  bool agrees;
};
using Neighbours = std::vector<std::vector<Neighbour>>;

Neighbours find_neighbours(const TriangleMesh& mesh, std::span<const EdgeUse> uses) {
  Neighbours neighbours(mesh.triangles.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) {
      const bool agrees = edge[0].direction != edge[1].direction;
      neighbours[edge[0].triangle].push_back({edge[1].triangle, agrees});
      neighbours[edge[1].triangle].push_back({edge[0].triangle, agrees});
    }
  });
  return neighbours;
}

// Carries the winding of one triangle of each patch over its whole patch.
void align_patches(TriangleMesh& mesh, std::span<const EdgeUse> uses) {
  const Neighbours neighbours = find_neighbours(mesh, uses);
  enum class State : std::uint8_t { kUnseen, kKept, kFlipped };
  std::vector<State> states(mesh.triangles.size(), State::kUnseen);
  std::vector<std::uint32_t> pending;
  for (std::uint32_t seed = 0; seed < states.size(); ++seed) {
    if (states[seed] != State::kUnseen) {
      continue;
    }
    states[seed] = State::kKept;
    pending.push_back(seed);
    while (!pending.empty()) {
      const std::uint32_t t = pending.back();
      pending.pop_back();
      for (const Neighbour& next : neighbours[t]) {
        if (states[next.triangle] == State::kUnseen) {
          const bool flipped = (states[t] == State::kFlipped) == next.agrees;
          states[next.triangle] = flipped ? State::kFlipped : State::kKept;
          pending.push_back(next.triangle);
        }
      }
    }
  }
  for (std::uint32_t t = 0; t < states.size(); ++t) {
    if (states[t] == State::kFlipped) {
      flip(mesh.triangles[t]);
    }
  }
}

}  // namespace

std::string describe_holes(const std::vector<Hole>& holes) {
  constexpr std::size_t kShown = 3;
  std::ostringstream text;
  text.precision(3);
  text << holes.size() << (holes.size() == 1 ? " hole: " : " holes: ");
  for (std::size_t i = 0; i < std::min(holes.size(), kShown); ++i) {
    const Hole& hole = holes[i];
    text << (i > 0 ? "; " : "") << "a loop of " << hole.edges << " edges around (" << hole.center.x << ", "
         << hole.center.y << ", " << hole.center.z << "), " << hole.width << " m wide";
  }
  if (holes.size() > kShown) {
    text << "; and " << holes.size() - kShown << " smaller";
  }
  return text.str();
}

MeshReport check_closed(const TriangleMesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  MeshReport report;
  report.holes = find_holes(mesh, uses);
  for_each_edge(uses,
                [&](std::span<const EdgeUse> edge) { report.crowded_edges += edge.size() > 2 ? 1 : 0; });
  report.inconsistent_edges = inconsistent_edges(uses);
  const PartList parts = find_parts(mesh, uses);
  report.components = parts.count;
  if (report.closed() && report.inconsistent_edges == 0) {
    const std::vector<bool> turned = find_inside_out(mesh, parts);
    report.inside_out = static_cast<std::size_t>(std::ranges::count(turned, true));
  }
  return report;
}

Result<TriangleMesh> make_solid(TriangleMesh mesh, std::string_view name) {
  std::vector<EdgeUse> uses = edge_uses(mesh);
  if (const std::vector<Hole> holes = find_holes(mesh, uses); !holes.empty()) {
    return fail(Error{Cause::kCaller,
                      "open mesh '" + std::string(name) + "'",
                      std::nullopt,
                      describe_holes(holes),
                      "a closed surface, or 'thin: true' for a wall of some thickness",
                      {}});
  }
  if (inconsistent_edges(uses) > 0) {
    align_patches(mesh, uses);
    uses = edge_uses(mesh);
  }
  if (const std::size_t wrong = inconsistent_edges(uses); wrong > 0) {
    return fail(Error{Cause::kCaller,
                      "mesh '" + std::string(name) + "' has no inside",
                      std::nullopt,
                      std::to_string(wrong) + " edges whose triangles cannot be made to face the same way",
                      "a surface with two sides, or 'thin: true'",
                      {}});
  }
  const PartList parts = find_parts(mesh, uses);
  const std::vector<bool> turned = find_inside_out(mesh, parts);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (turned[parts.of_triangle[t]]) {
      flip(mesh.triangles[t]);
    }
  }
  return mesh;
}

}  // namespace mayfly::fields
