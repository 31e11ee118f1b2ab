// Sampling on a nested grid: a coarse one over the whole world, with bricks of fine cells where they matter
// (core/nested_grid.hpp).
//
// A table holds its coarse cells first, x fastest, then the bricks. In the table of the walls the first part
// is not needed, for nothing of a wall is felt where there is no brick; instead it tells where the bricks
// are: its words are, bit by bit, whole numbers, the entry at which the coarse cell's brick starts, or 0 for
// none.
#ifndef MAYFLY_KERNELS_BRICKS_H
#define MAYFLY_KERNELS_BRICKS_H

#include "kernels/grid.h"

MF_BEGIN

#define MF_BRICK_RATIO 8  // fine cells along a coarse one
#define MF_BRICK_SIDE 10  // and those of a brick, with an apron of one cell
#define MF_BRICK_LAST 9.0f

// The lattice that a point's look-up reads, and where the point is on it.
typedef struct {
  I fine;                 // mask: in a brick
  I start;                // the lattice's first entry
  I row, plane;           // entries from one row to the next, from one plane to the next
  I end_x, end_y, end_z;  // the last cell along each axis
  F3 u;                   // cell coordinates: whole numbers at cell centres; within the lattice
} MfPlace;

// Cell coordinates along one axis, of the brick where `fine`, else of the coarse grid. q: in fine cells from
// the world's corner, c: the coarse cell.
MF_FN F mf_place_along(I fine, F q, I c, int n) {
  const F in_brick = mf_clamp(q - mf_to_float(c * MF_BRICK_RATIO) + 0.5f, 0.0f, MF_BRICK_LAST);
  const F in_coarse = mf_clamp(q * (1.0f / MF_BRICK_RATIO) - 0.5f, 0.0f, (float)(n - 1));
  return mf_select(fine, in_brick, in_coarse);
}

// Every point finds cells of the table, however far outside or broken it is. A point on the border of two
// coarse cells belongs to the upper one.
MF_FN MfPlace mf_place(F3 r, const MF_GLOBAL float* walls, const MfGrid* g) {
  const F3 from_origin = mf3_sub(r, mf3_splat(g->origin_x, g->origin_y, g->origin_z));
  const F3 q = mf3_scale(from_origin, mf_splat(g->inverse_cell));
  const float shrink = 1.0f / MF_BRICK_RATIO;
  const I cx = mf_clamp_index(mf_floor(q.x * shrink), g->nx);
  const I cy = mf_clamp_index(mf_floor(q.y * shrink), g->ny);
  const I cz = mf_clamp_index(mf_floor(q.z * shrink), g->nz);
  const I brick = mf_to_signed(mf_as_bits(mf_gather(walls, (cz * g->ny + cy) * g->nx + cx)));
  const I side = mf_isplat(MF_BRICK_SIDE);
  const I end = mf_isplat(MF_BRICK_SIDE - 1);
  MfPlace p;
  p.fine = brick > mf_isplat(0);
  p.start = brick;
  p.row = mf_iselect(p.fine, side, mf_isplat(g->nx));
  p.plane = mf_iselect(p.fine, side * MF_BRICK_SIDE, mf_isplat(g->nx * g->ny));
  p.end_x = mf_iselect(p.fine, end, mf_isplat(g->nx - 1));
  p.end_y = mf_iselect(p.fine, end, mf_isplat(g->ny - 1));
  p.end_z = mf_iselect(p.fine, end, mf_isplat(g->nz - 1));
  p.u = mf3(mf_place_along(p.fine, q.x, cx, g->nx), mf_place_along(p.fine, q.y, cy, g->ny),
            mf_place_along(p.fine, q.z, cz, g->nz));
  return p;
}

// The eight cells around a point: unlike in MfCube, the lanes differ in their steps.
typedef struct {
  I corner[8];
  F weight[8];
} MfCorners;

MF_FN MfCorners mf_place_corners(const MfPlace* p) {
  const I ix = mf_floor(p->u.x);
  const I iy = mf_floor(p->u.y);
  const I iz = mf_floor(p->u.z);
  const F3 t = mf3(p->u.x - mf_to_float(ix), p->u.y - mf_to_float(iy), p->u.z - mf_to_float(iz));
  const I x[2] = {p->start + ix, p->start + mf_imin(ix + 1, p->end_x)};
  const I y[2] = {iy * p->row, mf_imin(iy + 1, p->end_y) * p->row};
  const I z[2] = {iz * p->plane, mf_imin(iz + 1, p->end_z) * p->plane};
  const F wx[2] = {1.0f - t.x, t.x};
  const F wy[2] = {1.0f - t.y, t.y};
  const F wz[2] = {1.0f - t.z, t.z};
  MfCorners c;
  for (int k = 0; k < 8; ++k) {
    c.corner[k] = x[k & 1] + y[(k >> 1) & 1] + z[k >> 2];
    c.weight[k] = wx[k & 1] * (wy[(k >> 1) & 1] * wz[k >> 2]);
  }
  return c;
}

// Whether a wall is nearer than `reach` (m): never where there is no brick. The words of coarse cells are no
// numbers to calculate with: their lanes read the first brick instead.
MF_FN I mf_place_near_wall(const MfPlace* p, const MF_GLOBAL float* walls, const MfCorners* c,
                           const MfGrid* g, float reach) {
  if (!mf_any(p->fine)) return mf_isplat(0);
  const I first = mf_isplat(g->nx * g->ny * g->nz);
  F sum = mf_splat(0.0f);
  for (int k = 0; k < 8; ++k) {
    sum += c->weight[k] * mf_gather(walls, mf_iselect(p->fine, c->corner[k], first));
  }
  return p->fine & (sum < mf_splat(reach));
}

// The spline through the walls of the bricks; of lanes without one, some other's.
MF_FN MfSurface mf_place_surface(const MfPlace* p, const MF_GLOBAL float* walls, const MfGrid* g) {
  const I ix = mf_floor(p->u.x + 0.5f);
  const I iy = mf_floor(p->u.y + 0.5f);
  const I iz = mf_floor(p->u.z + 0.5f);
  const F3 t = mf3(p->u.x - mf_to_float(ix), p->u.y - mf_to_float(iy), p->u.z - mf_to_float(iz));
  const I start = mf_iselect(p->fine, p->start, mf_isplat(g->nx * g->ny * g->nz));
  I x[3], y[3], z[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = start + mf_clamp_index(ix + (k - 1), MF_BRICK_SIDE);
    y[k] = mf_clamp_index(iy + (k - 1), MF_BRICK_SIDE) * MF_BRICK_SIDE;
    z[k] = mf_clamp_index(iz + (k - 1), MF_BRICK_SIDE) * (MF_BRICK_SIDE * MF_BRICK_SIDE);
  }
  return mf_surface_of(walls, x, y, z, t, g->inverse_cell);
}

// What the tables hold around eight agents, on a regular grid or a nested one.
typedef struct {
  MfCube cube;
  MfPlace place;  // of a nested grid, as are the corners
  MfCorners corners;
} MfAround;

MF_FN MfAround mf_around(F3 r, const MF_GLOBAL float* walls, const MfGrid* g) {
  MfAround a;
  if (g->nested) {
    a.place = mf_place(r, walls, g);
    a.corners = mf_place_corners(&a.place);
  } else {
    a.cube = mf_cube(r, g);
  }
  return a;
}

// Trilinear interpolation of a table with four floats a cell.
MF_FN void mf_around_sample4(const MF_GLOBAL float* table, const MfAround* a, const MfGrid* g, F sum[4]) {
  if (!g->nested) {
    mf_sample4(table, &a->cube, sum);
    return;
  }
  for (int n = 0; n < 4; ++n) sum[n] = mf_splat(0.0f);
  for (int k = 0; k < 8; ++k) {
    F corner[4];
    mf_gather4(table, a->corners.corner[k] * 4, corner);
    for (int n = 0; n < 4; ++n) sum[n] += a->corners.weight[k] * corner[n];
  }
}

MF_FN MfSurface mf_around_surface(F3 r, const MfAround* a, const MF_GLOBAL float* walls, const MfGrid* g) {
  if (g->nested) return mf_place_surface(&a->place, walls, g);
  return mf_surface(r, walls, g);
}

MF_END

#endif
