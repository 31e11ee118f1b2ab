// Active Brownian particles (Schweitzer, Ebeling and Tilch 1998), for comparisons: an energy depot drives,
// friction brakes, a parabolic potential holds the swarm together.
#ifndef MAYFLY_KERNELS_BROWNIAN_H
#define MAYFLY_KERNELS_BROWNIAN_H

#include "kernels/draw.h"

MF_BEGIN

// The depot is in its stationary state.
typedef struct {
  float friction;                         // 1/s, γ0
  float intake, dissipation, conversion;  // m²/s³ q, 1/s c, s/m² d: the depot drives with d q / (c + d v²)
  float noise;                            // m/s^1.5, √(2D)
  float pull;                             // 1/s², a
  float x, y, z;                          // m, the centre
} MfBrownian;

// dv/dt = −γ0 v + d e v − a (r − centre), m/s², with e = q/(c + d v²); without a depot where c and d are 0.
MF_FN F3 mf_brownian_force(F3 r, F3 v, const MfBrownian* b) {
  const F level = b->dissipation + b->conversion * mf3_dot(v, v);
  const I empty = level <= mf_splat(0.0f);
  const F drive =
      mf_select(empty, mf_splat(0.0f), b->conversion * b->intake / mf_select(empty, mf_splat(1.0f), level));
  const F3 home = mf3_sub(mf3_splat(b->x, b->y, b->z), r);
  return mf3_add(mf3_scale(v, drive - b->friction), mf3_scale(home, mf_splat(b->pull)));
}

// √(2D) ξ over a tick as a force, m/s²: what it adds to v in `period` (s) has the variance 2D · period an
// axis.
MF_FN F3 mf_brownian_noise(I id, const MfBrownian* b, const MfMoment* moment, float period) {
  const uint s = MF_STREAM_BROWNIAN;
  const F3 g = mf3(mf_normal_draw(mf_draw(moment, id, s), mf_draw(moment, id, s + 1u)),
                   mf_normal_draw(mf_draw(moment, id, s + 2u), mf_draw(moment, id, s + 3u)),
                   mf_normal_draw(mf_draw(moment, id, s + 4u), mf_draw(moment, id, s + 5u)));
  return mf3_scale(g, b->noise / mf_sqrt(mf_splat(period)));
}

MF_END

#endif
