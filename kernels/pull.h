// What pulls single agents, or pushes them: lamps (Wang14 §7, phototaxis) and a user's brushes.
#ifndef MAYFLY_KERNELS_PULL_H
#define MAYFLY_KERNELS_PULL_H

#include "kernels/draw.h"
#include "kernels/ramp.h"

MF_BEGIN

#define MF_MAX_PULLS 16

#define MF_PULL_LAMP 0
#define MF_PULL_BRUSH 1

typedef struct {
  int kind;
  float x, y, z;      // m
  float reach;        // m: nothing from there on
  float speed;        // m/s toward (x, y, z); away from it where negative
  float probability;  // an agent and tick, MF_PULL_LAMP only
} MfPull;

// A lamp, out to its reach, with the given probability: the whole speed, straight toward it.
// A brush, always: the potential speed · (reach / s) · h(distance/reach) pulls along its gradient, h being
// the bell of Wang14 Eq. 6 and s its steepest slope, so that `speed` is reached where it is steepest.
MF_FN F3 mf_pull(F3 r, I id, const MfPull* pull, const MfMoment* moment, uint stream) {
  const F3 line = mf3_sub(mf3_splat(pull->x, pull->y, pull->z), r);
  const F distance = mf3_length(line);
  F speed = mf_splat(pull->speed);
  if (pull->kind == MF_PULL_BRUSH) {
    speed *= mf_bell_slope(distance * (1.0f / pull->reach)) * (1.0f / MF_BELL_STEEPEST);
  } else {
    const F draw = mf_unit_interval(mf_draw(moment, id, stream));
    const I felt = (draw < mf_splat(pull->probability)) & (distance < mf_splat(pull->reach));
    speed = mf_select(felt, speed, mf_splat(0.0f));
  }
  return mf3_scale(mf3_unit(line), speed);
}

MF_END

#endif
