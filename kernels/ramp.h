// The two scalar profiles of the field model, and the derivative that the boundary of the noise needs.
#ifndef MAYFLY_KERNELS_RAMP_H
#define MAYFLY_KERNELS_RAMP_H

#include "kernels/lane.h"

MF_BEGIN

// ramp(r) = 15/8 r − 10/8 r³ + 3/8 r⁵ for 0 ≤ r < 1, 0 below, 1 above (Wang14 Eq. 3, Chen19 Eq. 9).
MF_FN F mf_ramp(F r) {
  const F t = mf_clamp(r, 0.0f, 1.0f);
  const F t2 = t * t;
  return t * (1.875f + t2 * (-1.25f + t2 * 0.375f));
}

// d ramp/dr = 15/8 (1 − r²)² for 0 ≤ r < 1, else 0. At r = 0 the slope from above: agents are outside.
MF_FN F mf_ramp_slope(F r) {
  const F t = mf_clamp(r, 0.0f, 1.0f);
  const F rest = 1.0f - t * t;
  return mf_select(r < mf_splat(0.0f), mf_splat(0.0f), 1.875f * rest * rest);
}

// Repulsion bell h(r) = 1 for r < 0, 1 − 4/9 r⁶ + 17/9 r⁴ − 22/9 r² for 0 ≤ r ≤ 1, else 0 (Wang14 Eq. 6).
MF_FN F mf_bell(F r) {
  const F t = mf_clamp(r, 0.0f, 1.0f);
  const F t2 = t * t;
  return 1.0f + t2 * (-22.0f / 9.0f + t2 * (17.0f / 9.0f + t2 * (-4.0f / 9.0f)));
}

// −dh/dr of the bell, 0 where r < 0 or r > 1; the largest value, at r = 0.5035, is MF_BELL_STEEPEST.
#define MF_BELL_STEEPEST 1.5834297f
MF_FN F mf_bell_slope(F r) {
  const F t = mf_clamp(r, 0.0f, 1.0f);
  const F t2 = t * t;
  return (4.0f / 9.0f) * t * (1.0f - t2) * (11.0f - 6.0f * t2);
}

MF_END

#endif
