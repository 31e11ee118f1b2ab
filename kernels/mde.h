// Minimum distance enforcement (Wang14 §6): pairs that are too near are pushed apart along their line, half
// each.
#ifndef MAYFLY_KERNELS_MDE_H
#define MAYFLY_KERNELS_MDE_H

#include "kernels/lane.h"
#include "kernels/noise.h"

MF_BEGIN

// Agents sorted by the cell of a coarse grid, x fastest; start[c] is the first agent of cell c, start[c + 1]
// one past its last. A cell's side is at least the largest distance that is enforced.
typedef struct {
  float origin_x, origin_y, origin_z;  // m
  float inverse_cell;                  // 1/m
  int nx, ny, nz;
} MfCells;

// One agent as a neighbour search sees it.
typedef struct {
  float x, y, z;        // m
  float half_distance;  // m: two agents keep the sum of their halves apart
  int id;
} MfBody;

// Unit vectors for pairs at one point, which have no line between them: opposite for the two of a pair.
MF_FN F3 mf_parting(int self, I other) {
  const U h = mf_mix(mf_to_unsigned(other + self));
  const F3 v = mf3(mf_splat(1.0f), mf_to_float(mf_to_signed(h & 255u)) * (1.0f / 128.0f) - 1.0f,
                   mf_to_float(mf_to_signed((h >> 8) & 255u)) * (1.0f / 128.0f) - 1.0f);
  const F sign = mf_select(other < mf_isplat(self), mf_splat(1.0f), mf_splat(-1.0f));
  return mf3_scale(mf3_unit(v), sign);
}

// How far one agent at r moves because of eight others at q: half of each overlap, along q → r.
MF_FN F3 mf_push(F3 r, F3 q, F distance, I counts, F3 parting) {
  const F3 line = mf3_sub(r, q);
  const F length = mf3_length(line);
  const F overlap = distance - length;
  const I too_near = counts & (overlap > mf_splat(0.0f));
  const I coincident = length < mf_splat(1e-9f);
  const F3 direction = mf3_select(coincident, parting, mf3_unit(line));
  // The whole vector is selected: 0 times the direction to an agent without a place would be NaN.
  return mf3_select(too_near, mf3_scale(direction, 0.5f * overlap), mf3_splat(0.0f, 0.0f, 0.0f));
}

MF_FN int mf_cell_of(float at, float origin, float inverse_cell, int count) {
  const float u = (at - origin) * inverse_cell;
  if (!(u > 0.0f)) return 0;
  return u < (float)count ? (int)u : count - 1;
}

// The whole displacement of one agent: its 27 cells are nine rows of contiguous agents. Sums run in the order
// of the sorted agents, so that every engine and every number of threads adds the same numbers in the same
// order. x, y, z, half, id: the sorted columns, readable eight elements past their end.
MF_FN F3 mf_displacement(MfBody self, const MfCells* cells, const MF_GLOBAL int* start,
                         const MF_GLOBAL float* x, const MF_GLOBAL float* y, const MF_GLOBAL float* z,
                         const MF_GLOBAL float* half_distance, const MF_GLOBAL int* id) {
  const int cx = mf_cell_of(self.x, cells->origin_x, cells->inverse_cell, cells->nx);
  const int cy = mf_cell_of(self.y, cells->origin_y, cells->inverse_cell, cells->ny);
  const int cz = mf_cell_of(self.z, cells->origin_z, cells->inverse_cell, cells->nz);
  const int x0 = cx > 0 ? cx - 1 : 0;
  const int x1 = cx + 1 < cells->nx ? cx + 1 : cx;
  const int y0 = cy > 0 ? cy - 1 : 0;
  const int y1 = cy + 1 < cells->ny ? cy + 1 : cy;
  const int z0 = cz > 0 ? cz - 1 : 0;
  const int z1 = cz + 1 < cells->nz ? cz + 1 : cz;
  const F3 r = mf3_splat(self.x, self.y, self.z);
  F3 sum = mf3_splat(0.0f, 0.0f, 0.0f);
  for (int k = z0; k <= z1; ++k) {
    for (int j = y0; j <= y1; ++j) {
      const int row = (k * cells->ny + j) * cells->nx;
      const int end = start[row + x1 + 1];
      for (int a = start[row + x0]; a < end; a += MF_LANES) {
        const I other = mf_iload(id + a);
        const I counts = (mf_lane_index() + a < mf_isplat(end)) & (other != mf_isplat(self.id));
        const F3 q = mf3(mf_load(x + a), mf_load(y + a), mf_load(z + a));
        const F distance = mf_load(half_distance + a) + self.half_distance;
        const F3 line = mf3_sub(r, q);
        if (!mf_any(counts & (mf3_dot(line, line) < distance * distance))) continue;
        sum = mf3_add(sum, mf_push(r, q, distance, counts, mf_parting(self.id, other)));
      }
    }
  }
  return sum;
}

MF_END

#endif
