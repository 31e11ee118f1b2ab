// The border of a region that noise does not lead out of: what Wang14 §4 calls extended boundaries. A swarm
// that roams in its goal is kept there by its border, as agents are kept out of obstacles by theirs.
#ifndef MAYFLY_KERNELS_FENCE_H
#define MAYFLY_KERNELS_FENCE_H

#include "kernels/boundary.h"

MF_BEGIN

#define MF_FENCE_NONE 0
#define MF_FENCE_SPHERE 1
#define MF_FENCE_BOX 2

typedef struct {
  int kind;
  float x, y, z;                 // m, the centre
  float half_x, half_y, half_z;  // m; of a sphere all three are its radius
} MfFence;

// How deep inside a point is that lies by `line` (m) from the centre; negative outside.
MF_FN F mf_fence_depth(F3 line, const MfFence* fence) {
  if (fence->kind == MF_FENCE_SPHERE) return fence->half_x - mf3_length(line);
  const F zero = mf_splat(0.0f);
  const F x = fence->half_x - mf_max(line.x, zero - line.x);
  const F y = fence->half_y - mf_max(line.y, zero - line.y);
  const F z = fence->half_z - mf_max(line.z, zero - line.z);
  return mf_min(mf_min(x, y), z);
}

// A sphere's inside as a surface: φ = R − |line|, ∂∂φ = −(1 − n nᵀ)/|line|.
MF_FN MfSurface mf_sphere_inside(F3 line, float radius) {
  const F length = mf_max(mf3_length(line), mf_splat(1e-3f));
  const F per_length = 1.0f / length;
  const F3 n = mf3_scale(line, per_length);
  MfSurface s;
  s.value = radius - length;
  s.gradient = mf3_scale(n, mf_splat(-1.0f));
  s.xx = (n.x * n.x - 1.0f) * per_length;
  s.yy = (n.y * n.y - 1.0f) * per_length;
  s.zz = (n.z * n.z - 1.0f) * per_length;
  s.xy = n.x * n.y * per_length;
  s.xz = n.x * n.z * per_length;
  s.yz = n.y * n.z * per_length;
  return s;
}

// Along one axis of a box: the ramp of the depth below its nearer face, and the ramp's derivative.
typedef struct {
  F ramp, slope;
} MfFaceRamp;

MF_FN MfFaceRamp mf_face_ramp(F along, float extent, float d0) {
  const F zero = mf_splat(0.0f);
  const F depth = (extent - mf_max(along, zero - along)) * (1.0f / d0);
  const F slope = mf_ramp_slope(depth) * (1.0f / d0);
  MfFaceRamp f;
  f.ramp = mf_ramp(depth);
  f.slope = mf_select(along < zero, slope, zero - slope);
  return f;
}

// ∇ × N for N = (aʸaᶻ Pˣ, aᶻaˣ Pʸ, aˣaʸ Pᶻ), aᵏ the ramp below the nearer face of axis k: Wang14 Eq. 2 for
// six planes at once. At a face only the component of P normal to it is left; at edges and corners N is as
// smooth as the ramp, where the distance to a box is not.
MF_FN F3 mf_box_curl(const MfJet* p, F3 line, const MfFence* fence, float d0) {
  const MfFaceRamp x = mf_face_ramp(line.x, fence->half_x, d0);
  const MfFaceRamp y = mf_face_ramp(line.y, fence->half_y, d0);
  const MfFaceRamp z = mf_face_ramp(line.z, fence->half_z, d0);
  const F3 v = p->value;
  return mf3(x.ramp * ((y.slope * v.z + y.ramp * p->dy.z) - (z.slope * v.y + z.ramp * p->dz.y)),
             y.ramp * ((z.slope * v.x + z.ramp * p->dz.x) - (x.slope * v.z + x.ramp * p->dx.z)),
             z.ramp * ((x.slope * v.y + x.ramp * p->dx.y) - (y.slope * v.x + y.ramp * p->dy.x)));
}

// The curl noise of a potential inside the fence, tangential at its border.
MF_FN F3 mf_fenced_curl(const MfJet* p, F3 line, const MfFence* fence, float d0) {
  if (fence->kind == MF_FENCE_BOX) return mf_box_curl(p, line, fence, d0);
  const MfSurface s = mf_sphere_inside(line, fence->half_x);
  return mf_bounded_curl(p, &s, d0);
}

MF_END

#endif
