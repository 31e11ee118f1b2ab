// Who may be near eight agents: a swarm sorted by the cells of a grid, and a walk through the rows of cells
// within reach.
#ifndef MAYFLY_KERNELS_NEIGHBOURS_H
#define MAYFLY_KERNELS_NEIGHBOURS_H

#include "kernels/lane.h"

MF_BEGIN

// Cubes from a corner on. The outermost of them hold all that lies further out as well, so that any place has
// a cell, and an agent far off widens nothing.
typedef struct {
  float low_x, low_y, low_z;  // m
  float inverse;              // 1/m, of a cell's side
  int cells_x, cells_y, cells_z;
} MfCubes;

// Agents sorted by cell, x fastest, those of a cell by number; start[c] is the first agent of cell c, the
// element past the last cell says how many there are.
typedef struct {
  const MF_GLOBAL int* start;
  const MF_GLOBAL float *x, *y, *z;     // m
  const MF_GLOBAL float *vx, *vy, *vz;  // m/s
} MfNeighbours;

// Where places come to lie in units of cells, rounding takes less than this for up to 1024 cells an axis.
#define MF_CELL_MARGIN 1e-3f

// A place along an axis, in cells from the corner.
MF_FN F mf_in_cells(F at, float low, float inverse) {
  return mf_clamp((at - low) * inverse, -1e6f, 1e6f);
}
MF_FN I mf_cube_along(F in_cells, int cells) {
  return mf_imin(mf_imax(mf_floor(in_cells), mf_isplat(0)), mf_isplat(cells - 1));
}
MF_FN I mf_cube_index(F3 r, const MfCubes* c) {
  const I x = mf_cube_along(mf_in_cells(r.x, c->low_x, c->inverse), c->cells_x);
  const I y = mf_cube_along(mf_in_cells(r.y, c->low_y, c->inverse), c->cells_y);
  const I z = mf_cube_along(mf_in_cells(r.z, c->low_z, c->inverse), c->cells_z);
  return (z * c->cells_y + y) * c->cells_x + x;
}

// The box around eight agents, in cells from the corner.
typedef struct {
  float low_x, low_y, low_z, high_x, high_y, high_z;
} MfBox;

MF_FN MfBox mf_box_around(F3 r, const MfCubes* c) {
  const F x = mf_in_cells(r.x, c->low_x, c->inverse);
  const F y = mf_in_cells(r.y, c->low_y, c->inverse);
  const F z = mf_in_cells(r.z, c->low_z, c->inverse);
  MfBox box;
  box.low_x = mf_least(x);
  box.low_y = mf_least(y);
  box.low_z = mf_least(z);
  box.high_x = mf_greatest(x);
  box.high_y = mf_greatest(y);
  box.high_z = mf_greatest(z);
  return box;
}

// The cells along an axis within `reach` (in cells) of what lies between low and high.
MF_FN int mf_first_cube(float low, float reach, int cells) {
  const float at = low - reach - MF_CELL_MARGIN;
  return at <= 0.0f ? 0 : at >= (float)cells ? cells - 1 : (int)at;
}
MF_FN int mf_last_cube(float high, float reach, int cells) {
  const float at = high + reach + MF_CELL_MARGIN;
  return at <= 0.0f ? 0 : at >= (float)cells ? cells - 1 : (int)at;
}

// How far cells are from the box along an axis, in cells; outermost cells have no outer face.
MF_FN F mf_cube_gap(I cube, float low, float high, int cells) {
  const F at = mf_to_float(cube);
  const F none = mf_splat(0.0f);
  const F above = mf_select(cube > mf_isplat(0), at - high, none);
  const F below = mf_select(cube < mf_isplat(cells - 1), (low - 1.0f) - at, none);
  return mf_max(mf_max(above, below) - MF_CELL_MARGIN, none);
}

// Of eight rows of cells, y … y + 7 at z: which of their cells are within `reach` (in cells) of the box;
// none where first == past.
typedef struct {
  int first[MF_LANES], past[MF_LANES];
} MfRows;

MF_FN MfRows mf_rows(const MfBox* box, int y, int z, float reach, const MfCubes* c) {
  const F gap_y = mf_cube_gap(mf_lane_index() + y, box->low_y, box->high_y, c->cells_y);
  const F gap_z = mf_cube_gap(mf_isplat(z), box->low_z, box->high_z, c->cells_z);
  const F left = reach * reach * 1.0001f - (gap_y * gap_y + gap_z * gap_z);
  const I beyond = left < mf_splat(0.0f);
  const F along = mf_sqrt(mf_max(left, mf_splat(0.0f))) + MF_CELL_MARGIN;
  const I first = mf_cube_along(mf_clamp(box->low_x - along, -1e6f, 1e6f), c->cells_x);
  const I last = mf_cube_along(mf_clamp(box->high_x + along, -1e6f, 1e6f), c->cells_x);
  MfRows rows;
  mf_unpack(first, rows.first);
  mf_unpack(mf_iselect(beyond, first, last + 1), rows.past);
  return rows;
}

// 1/√a for normal a > 0 to 7e-7, some finite number for 0; out of multiplications, because root and division
// take four times as long. The first step's constants are those of J. Kadleč (2010), the second is Newton's.
MF_FN F mf_inverse_root(F a) {
  F y = mf_from_bits(0x5f1ffff9u - (mf_as_bits(a) >> 1));
  y = y * (1.68191391f - (0.703952253f * a) * (y * y));
  return y * (1.5f - (0.5f * a) * (y * y));
}

// Of which no unit vector is made: shorter than 1e-9 (model.md, conventions).
#define MF_TINY_SQUARED 1e-18f

// 1/|u| to 7e-7 of |u|², and 0 where |u| < 1e-9.
MF_FN F mf_quick_inverse(F squared) {
  return mf_kept(squared >= mf_splat(MF_TINY_SQUARED), mf_inverse_root(squared));
}

MF_END

#endif
