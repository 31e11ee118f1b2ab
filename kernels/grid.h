// Sampling of fields that are tabulated at the centres of a regular grid's cells. Outside the grid the border
// value goes on.
#ifndef MAYFLY_KERNELS_GRID_H
#define MAYFLY_KERNELS_GRID_H

#include "kernels/lane.h"

MF_BEGIN

typedef struct {
  float origin_x, origin_y, origin_z;  // m, corner of cell (0,0,0)
  float cell, inverse_cell;            // m, 1/m
  int nx, ny, nz;
  int nested;  // 1: `cell` is that of the bricks, nx, ny and nz count coarse cells (kernels/bricks.h)
} MfGrid;

// A scalar at a point with its first and second derivatives (per metre).
typedef struct {
  F value;
  F3 gradient;
  F xx, yy, zz, xy, xz, yz;
} MfSurface;

// Cell coordinates: whole numbers at cell centres.
MF_FN F3 mf_cell_coordinates(F3 r, const MfGrid* g) {
  const F3 from_origin = mf3_sub(r, mf3_splat(g->origin_x, g->origin_y, g->origin_z));
  const F3 u = mf3_scale(from_origin, mf_splat(g->inverse_cell));
  // Clamping also turns a NaN into a border cell: a bad position must not read outside the table.
  return mf3(mf_clamp(u.x - 0.5f, 0.0f, (float)(g->nx - 1)), mf_clamp(u.y - 0.5f, 0.0f, (float)(g->ny - 1)),
             mf_clamp(u.z - 0.5f, 0.0f, (float)(g->nz - 1)));
}

MF_FN I mf_clamp_index(I i, int count) {
  return mf_imin(mf_imax(i, mf_isplat(0)), mf_isplat(count - 1));
}

// The eight cells around a point: corner k is `base` plus whichever of the steps its bits name, x first.
typedef struct {
  I base;
  int step_x, step_y, step_z;  // the same in every lane; 0 along an axis with one cell only
  F3 t;                        // from the lowest corner, in cells: 0 … 1
  F weight[8];
} MfCube;

// At the upper border the cube ends at the last cell, so that all its corners are in the table.
MF_FN I mf_low_corner(F u, int count) {
  return mf_imin(mf_floor(u), mf_isplat(count > 1 ? count - 2 : 0));
}

MF_FN MfCube mf_cube(F3 r, const MfGrid* g) {
  const F3 u = mf_cell_coordinates(r, g);
  const I ix = mf_low_corner(u.x, g->nx);
  const I iy = mf_low_corner(u.y, g->ny);
  const I iz = mf_low_corner(u.z, g->nz);
  const F tx = u.x - mf_to_float(ix);
  const F ty = u.y - mf_to_float(iy);
  const F tz = u.z - mf_to_float(iz);
  const F w00 = (1.0f - ty) * (1.0f - tz);
  const F w10 = ty * (1.0f - tz);
  const F w01 = (1.0f - ty) * tz;
  const F w11 = ty * tz;
  MfCube c;
  c.base = (iz * g->ny + iy) * g->nx + ix;
  c.step_x = g->nx > 1 ? 1 : 0;
  c.step_y = g->ny > 1 ? g->nx : 0;
  c.step_z = g->nz > 1 ? g->nx * g->ny : 0;
  c.t = mf3(tx, ty, tz);
  c.weight[0] = (1.0f - tx) * w00;
  c.weight[1] = tx * w00;
  c.weight[2] = (1.0f - tx) * w10;
  c.weight[3] = tx * w10;
  c.weight[4] = (1.0f - tx) * w01;
  c.weight[5] = tx * w01;
  c.weight[6] = (1.0f - tx) * w11;
  c.weight[7] = tx * w11;
  return c;
}

MF_FN int mf_corner_step(const MfCube* c, int corner) {
  return (corner & 1) * c->step_x + ((corner >> 1) & 1) * c->step_y + (corner >> 2) * c->step_z;
}

// Index of the cell whose centre is nearest.
MF_FN I mf_nearest_corner(const MfCube* c) {
  const F middle = mf_splat(0.5f);
  return c->base + ((c->t.x > middle) & c->step_x) + ((c->t.y > middle) & c->step_y) +
         ((c->t.z > middle) & c->step_z);
}

// Trilinear interpolation of a table with one float a cell.
MF_FN F mf_sample(const MF_GLOBAL float* table, const MfCube* c) {
  F sum = mf_splat(0.0f);
  for (int k = 0; k < 8; ++k) sum += c->weight[k] * mf_gather(table + mf_corner_step(c, k), c->base);
  return sum;
}

// The same of a table with four floats a cell, all four at once.
MF_FN void mf_sample4(const MF_GLOBAL float* table, const MfCube* c, F sum[4]) {
  for (int n = 0; n < 4; ++n) sum[n] = mf_splat(0.0f);
  const I base = c->base * 4;
  for (int k = 0; k < 8; ++k) {
    F corner[4];
    mf_gather4(table + 4 * mf_corner_step(c, k), base, corner);
    for (int n = 0; n < 4; ++n) sum[n] += c->weight[k] * corner[n];
  }
}

// Weights of the quadratic B-spline on three cells around t in [-½, ½], with derivatives by the cell
// coordinate.
typedef struct {
  F w[3], d[3];
} MfSpline;

MF_FN MfSpline mf_spline(F t) {
  MfSpline s;
  const F low = 0.5f - t;
  const F high = 0.5f + t;
  s.w[0] = 0.5f * low * low;
  s.w[1] = 0.75f - t * t;
  s.w[2] = 0.5f * high * high;
  s.d[0] = -low;
  s.d[1] = -2.0f * t;
  s.d[2] = high;
  return s;
}

// The spline on the 27 cells of entries x[i] + y[j] + z[k]; t: cells from the middle one's centre.
MF_FN MfSurface mf_surface_of(const MF_GLOBAL float* table, const I* x, const I* y, const I* z, F3 t,
                              float inverse_cell) {
  const float second[3] = {1.0f, -2.0f, 1.0f};
  const MfSpline sx = mf_spline(t.x);
  const MfSpline sy = mf_spline(t.y);
  const MfSpline sz = mf_spline(t.z);
  const F zero = mf_splat(0.0f);
  MfSurface s;
  s.value = zero;
  s.gradient = mf3(zero, zero, zero);
  s.xx = zero;
  s.yy = zero;
  s.zz = zero;
  s.xy = zero;
  s.xz = zero;
  s.yz = zero;
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) {
      const I row = y[j] + z[k];
      F v = zero;
      F vx = zero;
      F vxx = zero;
      for (int i = 0; i < 3; ++i) {
        const F a = mf_gather(table, row + x[i]);
        v += sx.w[i] * a;
        vx += sx.d[i] * a;
        vxx += second[i] * a;
      }
      const F ww = sy.w[j] * sz.w[k];
      const F dw = sy.d[j] * sz.w[k];
      const F wd = sy.w[j] * sz.d[k];
      s.value += ww * v;
      s.gradient.x += ww * vx;
      s.gradient.y += dw * v;
      s.gradient.z += wd * v;
      s.xx += ww * vxx;
      s.yy += second[j] * sz.w[k] * v;
      s.zz += sy.w[j] * second[k] * v;
      s.xy += dw * vx;
      s.xz += wd * vx;
      s.yz += sy.d[j] * sz.d[k] * v;
    }
  }
  const F per_cell = mf_splat(inverse_cell);
  const F per_cell2 = per_cell * per_cell;
  s.gradient = mf3_scale(s.gradient, per_cell);
  s.xx *= per_cell2;
  s.yy *= per_cell2;
  s.zz *= per_cell2;
  s.xy *= per_cell2;
  s.xz *= per_cell2;
  s.yz *= per_cell2;
  return s;
}

// The quadratic B-spline through a scalar table: C¹, so that a potential made of it has a curl without
// divergence.
MF_FN MfSurface mf_surface(F3 r, const MF_GLOBAL float* table, const MfGrid* g) {
  const F3 u = mf_cell_coordinates(r, g);
  const I ix = mf_floor(u.x + 0.5f);
  const I iy = mf_floor(u.y + 0.5f);
  const I iz = mf_floor(u.z + 0.5f);
  const F3 t = mf3(u.x - mf_to_float(ix), u.y - mf_to_float(iy), u.z - mf_to_float(iz));
  I x[3], y[3], z[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = mf_clamp_index(ix + (k - 1), g->nx);
    y[k] = mf_clamp_index(iy + (k - 1), g->ny) * g->nx;
    z[k] = mf_clamp_index(iz + (k - 1), g->nz) * (g->nx * g->ny);
  }
  return mf_surface_of(table, x, y, z, t, g->inverse_cell);
}

MF_END

#endif
