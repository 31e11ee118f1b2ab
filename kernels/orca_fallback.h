// Where no velocity keeps all half-spaces: the one that breaks the worst of them least. Hard ones are kept,
// if they can be.
#ifndef MAYFLY_KERNELS_ORCA_FALLBACK_H
#define MAYFLY_KERNELS_ORCA_FALLBACK_H

#include "kernels/orca_programme.h"

MF_BEGIN

// Where plane q is broken no more than plane p is: again a half-space of velocities.
MF_FN MfPlane mf_no_worse(const MfPlane* q, const MfPlane* p) {
  const F3 between = mf3_sub(q->n, p->n);
  const F length2 = mf3_dot(between, between);
  // Looking the same way the two differ by a distance only; and where there is no q, nothing is broken.
  const I binds = (length2 > mf_splat(MF_PARALLEL * MF_PARALLEL)) & (mf3_dot(q->n, q->n) > mf_splat(0.5f));
  const F inverse = 1.0f / mf_sqrt(mf_select(binds, length2, mf_splat(1.0f)));
  MfPlane out;
  out.n = mf3_scale(between, inverse);
  out.d = (q->d - p->d) * inverse;
  return mf_plane_select(binds, out, mf_no_plane());
}

// The velocities `v` got stuck at plane `fails`; lanes with fails == count have nothing to do. Plane by
// plane: where one is broken more than all before it, the least violation lies where it is kept best among
// the velocities that break none of those before it more (the incremental programme, one dimension up).
MF_FN F3 mf_least_violation(const MfPlanes* c, F3 v, I fails, F most, F slack) {
  F worst = mf_splat(0.0f);
  int first[MF_LANES];
  mf_unpack(fails, first);
  int begin = c->count;
  for (int k = 0; k < MF_LANES; ++k) begin = first[k] < begin ? first[k] : begin;
  // Who cannot keep the hard ones keeps the firm ones at least.
  const I keeps_hard = fails >= mf_isplat(c->hard);
  MfPlanes less;
  for (int i = begin; i < c->count; ++i) {
    const MfPlane* p = &c->plane[i];
    const I worse = (fails <= mf_isplat(i)) & (p->d - mf3_dot(p->n, v) > worst + slack);
    if (!mf_any(worse)) continue;
    for (int j = 0; j < i; ++j) {
      const I kept = j < c->firm ? mf_isplat(-1) : keeps_hard & mf_isplat(j < c->hard ? -1 : 0);
      less.plane[j] = c->plane[j];
      if (!mf_all(kept)) less.plane[j] = mf_plane_select(kept, c->plane[j], mf_no_worse(&c->plane[j], p));
    }
    const MfGoal goal = {p->n, 1, most, slack};
    I stuck;
    const F3 best = mf_best_in_space(&less, i, &goal, worse, &stuck);
    // v keeps all of them but for rounding; what comes out stuck is thrown away.
    const I better = worse & (stuck == mf_isplat(i));
    v = mf3_select(better, best, v);
    worst = mf_select(worse, p->d - mf3_dot(p->n, v), worst);
  }
  return v;
}

MF_END

#endif
