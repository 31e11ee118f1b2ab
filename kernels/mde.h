// Minimum distance enforcement (Wang14 §6): pairs that are too near are pushed apart along their line, half each.
#ifndef MAYFLY_KERNELS_MDE_H
#define MAYFLY_KERNELS_MDE_H

#include "kernels/lane.h"

MF_BEGIN

// How far one agent at r moves because of eight others at q: half of each overlap, along q → r. Lanes where `counts` is 0
// (the agent itself, empty lanes) push nothing. Coincident agents have no line: `parting` (unit vectors, opposite for the
// two of a pair) stands in for it.
MF_FN F3 mf_push(F3 r, F3 q, I counts, F3 parting, float distance) {
  const F3 line = mf3_sub(r, q);
  const F length = mf3_length(line);
  const F overlap = mf_splat(distance) - length;
  const I near_enough = counts & (overlap > mf_splat(0.0f));
  const I coincident = length < mf_splat(1e-9f);
  const F3 direction = mf3_select(coincident, parting, mf3_unit(line));
  return mf3_scale(direction, mf_select(near_enough, 0.5f * overlap, mf_splat(0.0f)));
}

MF_END

#endif
