// Curl noise beside walls: the potential is bent so that its curl has no component through them (Wang14 Eq.
// 2).
#ifndef MAYFLY_KERNELS_BOUNDARY_H
#define MAYFLY_KERNELS_BOUNDARY_H

#include "kernels/grid.h"
#include "kernels/noise.h"
#include "kernels/ramp.h"

MF_BEGIN

// The outward unit normal n = ∇φ/|∇φ| with the derivatives of its components along x, y and z.
typedef struct {
  F3 n, dx, dy, dz;
} MfNormal;

MF_FN MfNormal mf_normal(const MfSurface* s) {
  MfNormal m;
  const F length = mf3_length(s->gradient);
  const I tiny = length < mf_splat(1e-6f);
  const F inverse = mf_select(tiny, mf_splat(0.0f), 1.0f / mf_select(tiny, mf_splat(1.0f), length));
  m.n = mf3_scale(s->gradient, inverse);
  // ∂n = (∂g − n (n·∂g)) / |g|
  const F3 hx = mf3(s->xx, s->xy, s->xz);
  const F3 hy = mf3(s->xy, s->yy, s->yz);
  const F3 hz = mf3(s->xz, s->yz, s->zz);
  m.dx = mf3_scale(mf3_sub(hx, mf3_scale(m.n, mf3_dot(m.n, hx))), inverse);
  m.dy = mf3_scale(mf3_sub(hy, mf3_scale(m.n, mf3_dot(m.n, hy))), inverse);
  m.dz = mf3_scale(mf3_sub(hz, mf3_scale(m.n, mf3_dot(m.n, hz))), inverse);
  return m;
}

// ∇ × N for N = αP + (1−α)(n·P)n, α = ramp(φ/d0) (Wang14 Eq. 2 with the trend of α as model.md corrects it):
// every derivative is taken of the interpolant that is sampled, so that the curl stays free of divergence.
MF_FN F3 mf_bounded_curl(const MfJet* p, const MfSurface* s, float d0) {
  const F r = s->value * (1.0f / d0);
  const F alpha = mf_ramp(r);
  const F3 grad_alpha = mf3_scale(s->gradient, mf_ramp_slope(r) * (1.0f / d0));
  const MfNormal m = mf_normal(s);
  const F beta = 1.0f - alpha;
  const F q = mf3_dot(m.n, p->value);
  const F3 grad_q =
      mf3(mf3_dot(m.dx, p->value) + mf3_dot(m.n, p->dx), mf3_dot(m.dy, p->value) + mf3_dot(m.n, p->dy),
          mf3_dot(m.dz, p->value) + mf3_dot(m.n, p->dz));
  const F3 grad_bq = mf3_sub(mf3_scale(grad_q, beta), mf3_scale(grad_alpha, q));
  const F3 curl_n = mf3(m.dy.z - m.dz.y, m.dz.x - m.dx.z, m.dx.y - m.dy.x);
  const F3 free_part = mf3_add(mf3_scale(mf_curl(*p), alpha), mf3_cross(grad_alpha, p->value));
  const F3 wall_part = mf3_add(mf3_cross(grad_bq, m.n), mf3_scale(curl_n, beta * q));
  return mf3_add(free_part, wall_part);
}

MF_END

#endif
