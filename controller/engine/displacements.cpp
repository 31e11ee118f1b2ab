#include "controller/engine/displacements.hpp"

#include <algorithm>
#include <cstring>

namespace mayfly {
namespace {

using kernels::MfPushed;
using kernels::MfReach;
using kernels::MfSorted;

constexpr std::size_t kChunk = 512;

std::uint64_t eight_flags(std::span<const std::uint8_t> flags, std::size_t first) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, &flags[first], sizeof eight);
  return eight;
}

MfReach reach_of_eight(const MfSorted& s, const kernels::MfCells& cells, std::size_t first,
                       SearchReach reach) {
  const kernels::F3 r = kernels::mf3(kernels::mf_load(s.x + first), kernels::mf_load(s.y + first),
                                     kernels::mf_load(s.z + first));
  return kernels::mf_reach(r, kernels::mf_load(s.half_distance + first), reach.farthest, reach.slack, &cells);
}

void store(Displacements& out, std::size_t a, const MfPushed& sum) {
  out.pushed[a] = static_cast<std::uint8_t>(sum.neighbours);
  if (sum.neighbours != 0) {
    out.x[a] = kernels::mf_metres(sum.x);
    out.y[a] = kernels::mf_metres(sum.y);
    out.z[a] = kernels::mf_metres(sum.z);
  }
}

}  // namespace

void Displacements::resize(std::size_t agents) {
  const std::size_t padded = agents + MF_LANES;
  for (std::vector<float>* column : {&x, &y, &z}) {
    column->assign(padded, 0.0F);
  }
  pushed.assign(padded, 0);
}

void displace_all(const CellOrder& order, std::size_t agents, SearchReach reach, Displacements& out,
                  ThreadTeam& team) noexcept {
  team.for_ranges(agents, kChunk, [&](std::size_t first, std::size_t last) {
    const MfSorted sorted = order.sorted();
    const kernels::MfCells cells = order.cells();
    for (std::size_t eight = first; eight < last; eight += MF_LANES) {
      const MfReach box = reach_of_eight(sorted, cells, eight, reach);
      const std::size_t lanes = std::min<std::size_t>(MF_LANES, last - eight);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        store(out, eight + lane,
              kernels::mf_pushed(static_cast<int>(eight + lane), static_cast<int>(lane), &box, &cells,
                                 &sorted, nullptr));
      }
    }
  });
}

void displace_marked(const CellOrder& order, std::size_t agents, SearchReach reach,
                     std::span<std::uint8_t> marks, Displacements& out, ThreadTeam& team) noexcept {
  team.for_ranges(agents, kChunk, [&](std::size_t first, std::size_t last) {
    const MfSorted sorted = order.sorted();
    const kernels::MfCells cells = order.cells();
    std::fill(out.pushed.begin() + static_cast<std::ptrdiff_t>(first),
              out.pushed.begin() + static_cast<std::ptrdiff_t>(last), std::uint8_t{0});
    for (std::size_t eight = first; eight < last; eight += MF_LANES) {
      if (eight_flags(marks, eight) == 0) {
        continue;
      }
      const MfReach box = reach_of_eight(sorted, cells, eight, reach);
      for (std::size_t a = eight; a < std::min(eight + MF_LANES, last); ++a) {
        if (marks[a] != 0) {
          marks[a] = 0;
          store(out, a,
                kernels::mf_pushed(static_cast<int>(a), static_cast<int>(a - eight), &box, &cells, &sorted,
                                   nullptr));
        }
      }
    }
  });
}

void mark_neighbours(const CellOrder& order, std::size_t agents, SearchReach reach,
                     std::span<const std::uint8_t> moved, std::span<std::uint8_t> marks,
                     ThreadTeam& team) noexcept {
  team.for_ranges(agents, kChunk, [&](std::size_t first, std::size_t last) {
    const MfSorted sorted = order.sorted();
    const kernels::MfCells cells = order.cells();
    for (std::size_t eight = first; eight < last; eight += MF_LANES) {
      if (eight_flags(moved, eight) == 0) {
        continue;
      }
      const MfReach box = reach_of_eight(sorted, cells, eight, reach);
      for (std::size_t a = eight; a < std::min(eight + MF_LANES, last); ++a) {
        if (moved[a] == 0) {
          continue;
        }
        const MfPushed sum = kernels::mf_pushed(static_cast<int>(a), static_cast<int>(a - eight), &box,
                                                &cells, &sorted, marks.data());
        if (sum.neighbours != 0) {
          kernels::mf_mark(&marks[a]);
        }
      }
    }
  });
}

}  // namespace mayfly
