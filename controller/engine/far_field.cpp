#include "controller/engine/far_field.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

using kernels::F;
using kernels::F3;

constexpr std::size_t kMostStrays = 256;

std::size_t cubes_in(const kernels::MfCubes& c) {
  return static_cast<std::size_t>(c.cells_x) * static_cast<std::size_t>(c.cells_y) *
         static_cast<std::size_t>(c.cells_z);
}
std::size_t nodes_in(const kernels::MfCubes& c) {
  return static_cast<std::size_t>(c.cells_x + 1) * static_cast<std::size_t>(c.cells_y + 1) *
         static_cast<std::size_t>(c.cells_z + 1);
}

// m between nodes, so that the mean error of the force is below `error`. Lumps on the edge of the zone make
// most of it; it was found to grow with the square of their size, and the factor leaves a margin of two to
// five (docs/decisions/0015-forces-and-far-field.md).
double node_spacing(double error, double att_radius, double extent) {
  return 0.5 * std::sqrt(error) * std::min(att_radius, 0.5 * extent);
}

}  // namespace

void FarField::reserve(std::size_t agents) {
  const std::size_t cubes = most_nodes(agents);
  nodes_.assign(4 * cubes, 0.0F);
  sums_.assign(cubes, {});
  start_.assign(cubes + 1, 0);
  for (std::vector<float>* column : {&x_, &y_, &z_, &mass_}) {
    column->assign(cubes + kMostStrays, 0.0F);
  }
  strays_.assign(kMostStrays, 0);
}

void FarField::build(const NeighbourGrid& grid, const SwarmModel& model, ThreadTeam& team) noexcept {
  mesh_.on = choose_cubes(grid, model) && gather_lumps(grid) ? 1 : 0;
  if (mesh_.on == 0) {
    return;
  }
  const auto row = static_cast<std::size_t>(mesh_.cubes.cells_x) / MF_LANES + 1;
  const std::size_t rows = nodes_in(mesh_.cubes) / static_cast<std::size_t>(mesh_.cubes.cells_x + 1);
  team.for_ranges(rows * row, 1, [&](std::size_t first, std::size_t last) { fill_nodes(first, last); });
}

bool FarField::choose_cubes(const NeighbourGrid& grid, const SwarmModel& model) noexcept {
  const kernels::MfForces& f = model.forces;
  if (model.far_error <= 0.0F || f.att_weight == 0.0F || f.att_radius <= 0.0F) {
    return false;
  }
  const kernels::MfCubes& fine = grid.cubes();
  const double side = 1.0 / static_cast<double>(fine.inverse);
  const double spacing = node_spacing(static_cast<double>(model.far_error), static_cast<double>(f.att_radius),
                                      side * std::max({fine.cells_x, fine.cells_y, fine.cells_z}));
  double nodes = 1.0;
  double in_reach = 1.0;  // of all agents, at the most
  const auto along = [&](int cells) {
    const double length = side * cells;
    const double cubes = std::clamp(std::ceil(length / spacing), 1.0, 1000.0);
    nodes *= cubes + 1;
    in_reach *= std::min(1.0, 2.0 * static_cast<double>(f.att_radius) / length);
    return static_cast<int>(cubes);
  };
  mesh_.cubes = fine;
  mesh_.cubes.inverse = static_cast<float>(1.0 / spacing);
  mesh_.cubes.cells_x = along(fine.cells_x);
  mesh_.cubes.cells_y = along(fine.cells_y);
  mesh_.cubes.cells_z = along(fine.cells_z);
  mesh_.att_radius = f.att_radius;
  mesh_.ali_radius = f.ali_radius;
  const auto agents = static_cast<double>(grid.count());
  // All pairs, against nodes by lumps and a mesh that is read.
  constexpr double kReadMesh = 100.0;
  return nodes < static_cast<double>(most_nodes(grid.count())) &&
         nodes * std::min(nodes, agents) * in_reach + kReadMesh * agents < agents * agents * in_reach;
}

// Sums the sorted agents cube by cube, in their order: lumps have the same bits on any number of threads.
bool FarField::gather_lumps(const NeighbourGrid& grid) noexcept {
  const kernels::MfCubes& c = mesh_.cubes;
  const std::size_t cubes = cubes_in(c);
  std::fill_n(sums_.begin(), cubes, Sum{});
  stray_count_ = 0;
  const kernels::MfNeighbours n = grid.neighbours();
  for (std::size_t eight = 0; eight < grid.count(); eight += MF_LANES) {
    const F3 r = kernels::mf3(kernels::mf_load(n.x + eight), kernels::mf_load(n.y + eight),
                              kernels::mf_load(n.z + eight));
    const kernels::I within = kernels::mf_within_mesh(kernels::mf_in_mesh(r, &c), &c);
    const kernels::I cube = kernels::mf_cube_index(r, &c);
    const std::size_t lanes = std::min<std::size_t>(MF_LANES, grid.count() - eight);
    for (std::size_t k = 0; k < lanes; ++k) {
      if (within[k] == 0) {
        if (stray_count_ == kMostStrays) {
          return false;
        }
        strays_[stray_count_++] = static_cast<int>(eight + k);
        continue;
      }
      Sum& sum = sums_[static_cast<std::size_t>(cube[k])];
      sum.x += static_cast<double>(r.x[k]);
      sum.y += static_cast<double>(r.y[k]);
      sum.z += static_cast<double>(r.z[k]);
      ++sum.agents;
    }
  }
  std::size_t lumps = 0;
  for (std::size_t cell = 0; cell < cubes; ++cell) {
    start_[cell] = static_cast<int>(lumps);
    if (const Sum& sum = sums_[cell]; sum.agents > 0) {
      x_[lumps] = static_cast<float>(sum.x / sum.agents);
      y_[lumps] = static_cast<float>(sum.y / sum.agents);
      z_[lumps] = static_cast<float>(sum.z / sum.agents);
      mass_[lumps++] = static_cast<float>(sum.agents);
    }
  }
  start_[cubes] = static_cast<int>(lumps);
  for (std::size_t s = 0; s < stray_count_; ++s) {
    const auto slot = static_cast<std::size_t>(strays_[s]);
    x_[lumps + s] = n.x[slot];
    y_[lumps + s] = n.y[slot];
    z_[lumps + s] = n.z[slot];
    mass_[lumps + s] = 1.0F;
  }
  return true;
}

// Whether any of the cubes about a node has agents in it.
bool FarField::is_read(int x, int y, int z) const noexcept {
  const kernels::MfCubes& c = mesh_.cubes;
  for (int k = std::max(z - 1, 0); k <= std::min(z, c.cells_z - 1); ++k) {
    for (int j = std::max(y - 1, 0); j <= std::min(y, c.cells_y - 1); ++j) {
      const int row = (k * c.cells_y + j) * c.cells_x;
      const auto first = static_cast<std::size_t>(row + std::max(x - 1, 0));
      const auto past = static_cast<std::size_t>(row + std::min(x + MF_LANES, c.cells_x));
      if (start_[first] != start_[past]) {
        return true;
      }
    }
  }
  return false;
}

// Eights of nodes `first` … last − 1, row by row.
void FarField::fill_nodes(std::size_t first, std::size_t last) noexcept {
  const kernels::MfCubes& c = mesh_.cubes;
  const kernels::MfLumps lumps{start_.data(), x_.data(),    y_.data(),
                               z_.data(),     mass_.data(), static_cast<int>(stray_count_)};
  const auto in_row = static_cast<std::size_t>(c.cells_x) / MF_LANES + 1;
  const float side = 1.0F / c.inverse;
  for (std::size_t eight = first; eight < last; ++eight) {
    const int x = static_cast<int>(eight % in_row) * MF_LANES;
    const int row = static_cast<int>(eight / in_row);
    const int y = row % (c.cells_y + 1);
    const int z = row / (c.cells_y + 1);
    if (!is_read(x, y, z)) {
      continue;
    }
    // Beyond the row's end the last node again: its box is not to grow.
    const kernels::I along = kernels::mf_imin(kernels::mf_lane_index() + x, kernels::mf_isplat(c.cells_x));
    const F3 corner = kernels::mf3(c.low_x + kernels::mf_to_float(along) * side,
                                   kernels::mf_splat(c.low_y + static_cast<float>(y) * side),
                                   kernels::mf_splat(c.low_z + static_cast<float>(z) * side));
    const kernels::MfFar far = kernels::mf_far_at(corner, &lumps, &mesh_);
    const int lanes = std::min(MF_LANES, c.cells_x + 1 - x);
    for (int k = 0; k < lanes; ++k) {
      const int node = row * (c.cells_x + 1) + x + k;
      float* to = &nodes_[4 * static_cast<std::size_t>(node)];
      to[0] = far.sum.x[k];
      to[1] = far.sum.y[k];
      to[2] = far.sum.z[k];
      to[3] = far.count[k];
    }
  }
}

}  // namespace mayfly
