// Minimum distance enforcement (Wang14 §6): pairs that are too near are pushed apart along their line, half
// each.
#ifndef MAYFLY_KERNELS_MDE_H
#define MAYFLY_KERNELS_MDE_H

#include "kernels/lane.h"
#include "kernels/noise.h"

MF_BEGIN

// The cells of a coarse grid that repeats itself in space, each axis after a power of two of them: any place
// has a cell, and an agent far off disturbs nobody.
typedef struct {
  float origin_x, origin_y, origin_z;     // m
  float inverse_x, inverse_y, inverse_z;  // 1/m, of a cell's sides
  int bits_x, bits_y, bits_z;             // there are 2^bits along each axis
} MfCells;

// Agents sorted by cell, x fastest; start[c] is the first agent of cell c, start[c + 1] one past its last.
// The other columns are readable eight elements past their end.
typedef struct {
  const MF_GLOBAL int* start;
  const MF_GLOBAL float *x, *y, *z;      // m
  const MF_GLOBAL float* half_distance;  // m: two agents keep the sum of their halves apart
  const MF_GLOBAL int* id;               // the agent's number before sorting
} MfSorted;

// Unit vectors for pairs at one point, which have no line between them: opposite for the two of a pair.
MF_FN F3 mf_parting(I self, I other) {
  const U h = mf_mix(mf_to_unsigned(other + self));
  const F3 v = mf3(mf_splat(1.0f), mf_to_float(mf_to_signed(h & 255u)) * (1.0f / 128.0f) - 1.0f,
                   mf_to_float(mf_to_signed((h >> 8) & 255u)) * (1.0f / 128.0f) - 1.0f);
  const F sign = mf_select(other < self, mf_splat(1.0f), mf_splat(-1.0f));
  return mf3_scale(mf3_unit(v), sign);
}

// Which of eight agents, `line` away, are nearer than `distance`.
MF_FN I mf_too_near(F3 line, F distance) {
  return mf3_dot(line, line) < distance * distance;
}

// How far one agent moves because of eight others: half of each overlap, along `line`, which leads from them
// to it. `parting` is for those at the same point.
MF_FN F3 mf_push(F3 line, F distance, I too_near, F3 parting) {
  const F length = mf3_length(line);
  const F overlap = mf_max(distance - length, mf_splat(0.0f));
  const I coincident = length < mf_splat(1e-9f);
  const F3 direction = mf3_select(coincident, parting, mf3_unit(line));
  // The whole vector is selected: 0 times the direction to an agent without a place would be NaN.
  return mf3_select(too_near, mf3_scale(direction, 0.5f * overlap), mf3_splat(0.0f, 0.0f, 0.0f));
}

// On which cell along an axis, before it is folded into the grid. Rounding keeps order: what lies between two
// places lies between their cells.
MF_FN I mf_cell_along(F at, float origin, float inverse) {
  return mf_floor(mf_clamp((at - origin) * inverse, -268435456.0f, 268435456.0f));
}

MF_FN I mf_cell_index(F3 r, const MfCells* c) {
  const I ix = mf_cell_along(r.x, c->origin_x, c->inverse_x) & ((1 << c->bits_x) - 1);
  const I iy = mf_cell_along(r.y, c->origin_y, c->inverse_y) & ((1 << c->bits_y) - 1);
  const I iz = mf_cell_along(r.z, c->origin_z, c->inverse_z) & ((1 << c->bits_z) - 1);
  return (((iz << c->bits_y) | iy) << c->bits_x) | ix;
}

// For each of eight agents the cells along one axis in which its neighbours may be.
typedef struct {
  int first[MF_LANES], count[MF_LANES];
} MfRange;

MF_FN MfRange mf_range(F at, F reach, float origin, float inverse, int bits) {
  const int last = (1 << bits) - 1;
  const I low = mf_cell_along(at - reach, origin, inverse);
  const I high = mf_cell_along(at + reach, origin, inverse);
  MfRange range;
  mf_unpack(low & last, range.first);
  mf_unpack(mf_imin(high - low, mf_isplat(last)) + 1, range.count);
  return range;
}

typedef struct {
  MfRange x, y, z;
} MfReach;

// Of agents whose neighbours, and themselves, may have moved `slack` (m) since they were sorted. `farthest`
// (m) is the largest half distance of all. A thousandth and the slack make up for rounding.
MF_FN MfReach mf_reach(F3 r, F half_distance, float farthest, float slack, const MfCells* c) {
  const F reach = (half_distance + farthest) * 1.001f + slack;
  MfReach box;
  box.x = mf_range(r.x, reach, c->origin_x, c->inverse_x, c->bits_x);
  box.y = mf_range(r.y, reach, c->origin_y, c->inverse_y, c->bits_y);
  box.z = mf_range(r.z, reach, c->origin_z, c->inverse_z, c->bits_z);
  return box;
}

// The sum of what pushes one agent, in units of 2^-32 m: whole numbers, so that it does not matter in which
// order, and by which cells, neighbours are found.
typedef struct {
  Long x, y, z;
  int neighbours;  // whether anybody is too near
} MfPushed;

// Adds the sorted agents first … last − 1. Where `marks` is given, who is too near gets a mark.
MF_FN void mf_add_pushes(MfPushed* sum, int self, const MfSorted* s, int first, int last,
                         MF_GLOBAL uchar* marks) {
  const F3 r = mf3_splat(s->x[self], s->y[self], s->z[self]);
  const F own = mf_splat(s->half_distance[self]);
  for (int a = first; a < last; a += MF_LANES) {
    const F3 line = mf3_sub(r, mf3(mf_load(s->x + a), mf_load(s->y + a), mf_load(s->z + a)));
    const F distance = mf_load(s->half_distance + a) + own;
    const I slot = mf_lane_index() + a;
    const I near_ones = mf_too_near(line, distance) & (slot < mf_isplat(last)) & (slot != mf_isplat(self));
    if (!mf_any(near_ones)) continue;
    sum->neighbours = 1;
    if (marks) {
      int is_near[MF_LANES];
      mf_unpack(near_ones, is_near);
      for (int k = 0; k < MF_LANES; ++k) {
        if (is_near[k]) mf_mark(marks + a + k);
      }
      continue;
    }
    const F3 push =
        mf_push(line, distance, near_ones, mf_parting(mf_isplat(s->id[self]), mf_iload(s->id + a)));
    sum->x += mf_sum_fixed(push.x);
    sum->y += mf_sum_fixed(push.y);
    sum->z += mf_sum_fixed(push.z);
  }
}

// All that pushes the sorted agent `self`, which is lane `lane` of `box`.
MF_FN MfPushed mf_pushed(int self, int lane, const MfReach* box, const MfCells* c, const MfSorted* s,
                         MF_GLOBAL uchar* marks) {
  MfPushed sum = {0, 0, 0, 0};
  const int first = box->x.first[lane];
  const int past = first + box->x.count[lane];
  const int cells_x = 1 << c->bits_x;
  for (int k = 0; k < box->z.count[lane]; ++k) {
    const int plane = ((box->z.first[lane] + k) & ((1 << c->bits_z) - 1)) << c->bits_y;
    for (int j = 0; j < box->y.count[lane]; ++j) {
      const int row = (plane | ((box->y.first[lane] + j) & ((1 << c->bits_y) - 1))) << c->bits_x;
      const MF_GLOBAL int* start = s->start + row;
      mf_add_pushes(&sum, self, s, start[first], start[past < cells_x ? past : cells_x], marks);
      if (past > cells_x) mf_add_pushes(&sum, self, s, start[0], start[past - cells_x], marks);
    }
  }
  return sum;
}

MF_FN float mf_metres(Long fixed) {
  return (float)fixed * (1.0f / 4294967296.0f);
}

MF_END

#endif
