// The velocity nearest to the one wanted among those that half-spaces and a speed limit leave: an incremental
// programme in three stages, on a line, on a plane and in space (van den Berg et al. 2011, §5; de Berg et
// al., Computational Geometry, chapter 4). Eight agents at a time: each stage is run while any of them needs
// it.
#ifndef MAYFLY_KERNELS_ORCA_PROGRAMME_H
#define MAYFLY_KERNELS_ORCA_PROGRAMME_H

#include "kernels/orca_plane.h"

MF_BEGIN

// Three bounds and a wall; a gap and an obstacle a neighbour.
#define MF_MAX_PLANES (4 + 2 * MF_MAX_NEIGHBOURS)

// In the order in which they come where not all can be kept: the first `firm` are the surroundings', those up
// to `hard` the gaps'.
typedef struct {
  MfPlane plane[MF_MAX_PLANES];
  int firm, hard, count;
} MfPlanes;

// What is looked for.
typedef struct {
  F3 wish;       // m/s; a unit vector where a direction is looked for
  int directed;  // 0: as near to `wish` as can be; 1: as far along it
  F most;        // m/s, the speed limit
  F slack;       // m/s: what rounding takes
} MfGoal;

// Two planes, or a line and a plane, that meet at a smaller sine than this are taken as parallel.
#define MF_PARALLEL 1e-3f

MF_FN I mf_breaks(const MfPlane* p, F3 v, F slack) {
  return mf3_dot(p->n, v) < p->d - slack;
}

// The best point of a line at a unit direction, whose point nearest to zero is `point`, within the first
// `count` planes; `none` gets those lanes that have no such point.
MF_FN F3 mf_best_on_line(const MfPlanes* c, int count, F3 point, F3 direction, const MfGoal* goal, I* none) {
  const F room = goal->most * goal->most - mf3_dot(point, point);
  const F reach = mf_sqrt(mf_max(room, mf_splat(0.0f)));
  I empty = room < mf_splat(0.0f);
  F low = -reach;
  F high = reach;
  for (int k = 0; k < count; ++k) {
    const MfPlane* p = &c->plane[k];
    const F slope = mf3_dot(direction, p->n);
    const F lack = p->d - mf3_dot(point, p->n);
    const I rises = slope > mf_splat(MF_PARALLEL);
    const I falls = slope < mf_splat(-MF_PARALLEL);
    const F at = lack / mf_select(rises | falls, slope, mf_splat(1.0f));
    low = mf_select(rises & (at > low), at, low);
    high = mf_select(falls & (at < high), at, high);
    empty = empty | (~(rises | falls) & (lack > goal->slack));
  }
  *none = *none | empty | (low > high + goal->slack);
  const F wished = mf3_dot(direction, goal->wish);
  F best = mf_min(mf_max(wished, low), high);
  if (goal->directed) best = mf_select(wished > mf_splat(0.0f), high, low);
  return mf3_add(point, mf3_scale(direction, best));
}

// The best point of plane `i` with nothing but the speed limit to keep.
MF_FN F3 mf_best_on_disc(const MfPlane* p, const MfGoal* goal, I* none) {
  const F room = goal->most * goal->most - p->d * p->d;
  *none = room < mf_splat(0.0f);
  const F3 centre = mf3_scale(p->n, p->d);
  const F3 across = mf3_sub(goal->wish, mf3_scale(p->n, mf3_dot(p->n, goal->wish)));
  const F across2 = mf3_dot(across, across);
  const I tiny = across2 <= mf_splat(1e-10f);
  const F to_rim = mf_sqrt(mf_max(room, mf_splat(0.0f)) / mf_select(tiny, mf_splat(1.0f), across2));
  F step = mf_min(to_rim, mf_splat(1.0f));
  if (goal->directed) step = mf_select(tiny, mf_splat(0.0f), to_rim);
  return mf3_add(centre, mf3_scale(across, mf_select(tiny & (across2 > room), mf_splat(0.0f), step)));
}

// The best point of plane `i` within the planes before it, for the lanes of `wanted`; `none` gets those of
// them that have no such point.
MF_FN F3 mf_best_on_plane(const MfPlanes* c, int i, const MfGoal* goal, I wanted, I* none) {
  const MfPlane* p = &c->plane[i];
  I failed;
  F3 v = mf_best_on_disc(p, goal, &failed);
  for (int j = 0; j < i; ++j) {
    const MfPlane* q = &c->plane[j];
    I broken = wanted & ~failed & mf_breaks(q, v, goal->slack);
    if (!mf_any(broken)) continue;
    const F3 cross = mf3_cross(q->n, p->n);
    const F sine2 = mf3_dot(cross, cross);
    const I parallel = sine2 <= mf_splat(MF_PARALLEL * MF_PARALLEL);
    // Of two that look the same way, `i` is the narrower: the best so far kept j and broke i.
    const F cosine = mf3_dot(q->n, p->n);
    failed = failed | (broken & parallel & (cosine < mf_splat(0.0f)));
    broken = broken & ~parallel;
    if (!mf_any(broken)) continue;
    const F sine = mf_sqrt(mf_select(parallel, mf_splat(1.0f), sine2));
    const F3 direction = mf3_scale(cross, 1.0f / sine);
    const F3 down = mf3_cross(direction, p->n);
    const F steepness = mf3_dot(down, q->n);
    const F along = (q->d - p->d * cosine) / mf_select(parallel, mf_splat(1.0f), steepness);
    const F3 point = mf3_add(mf3_scale(p->n, p->d), mf3_scale(down, along));
    I empty = mf_isplat(0);
    const F3 best = mf_best_on_line(c, j, point, direction, goal, &empty);
    failed = failed | (broken & empty);
    v = mf3_select(broken & ~empty, best, v);
  }
  *none = failed;
  return v;
}

// The best velocity of all, for the lanes of `wanted`. `fails` becomes the plane at which no velocity was
// left that keeps it and those before, or `count`; the velocity is then the best that keeps those before.
MF_FN F3 mf_best_in_space(const MfPlanes* c, int count, const MfGoal* goal, I wanted, I* fails) {
  const F3 wish = goal->wish;
  const F length2 = mf3_dot(wish, wish);
  const I fast = length2 > goal->most * goal->most;
  const F scale = goal->most / mf_sqrt(mf_select(fast, length2, mf_splat(1.0f)));
  F3 v = mf3_scale(wish, goal->directed ? goal->most : mf_select(fast, scale, mf_splat(1.0f)));
  *fails = mf_isplat(count);
  for (int i = 0; i < count; ++i) {
    const I broken = wanted & mf_breaks(&c->plane[i], v, goal->slack);
    if (!mf_any(broken)) continue;
    I none;
    const F3 best = mf_best_on_plane(c, i, goal, broken, &none);
    none = none & broken;
    v = mf3_select(broken & ~none, best, v);
    *fails = mf_iselect(none, mf_isplat(i), *fails);
    wanted = wanted & ~none;
    if (!mf_any(wanted)) break;
  }
  return v;
}

MF_END

#endif
