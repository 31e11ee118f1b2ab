// The velocities that keep two agents clear of each other, as a half-space (van den Berg et al. 2011, §4).
#ifndef MAYFLY_KERNELS_ORCA_PLANE_H
#define MAYFLY_KERNELS_ORCA_PLANE_H

#include "kernels/forces.h"
#include "kernels/mde.h"

MF_BEGIN

// The half-space n · v >= d; n is a unit vector, d in m/s. One that holds for every velocity has n = 0, d <
// 0.
typedef struct {
  F3 n;
  F d;
} MfPlane;

MF_FN MfPlane mf_no_plane(void) {
  MfPlane p;
  p.n = mf3_splat(0.0f, 0.0f, 0.0f);
  p.d = mf_splat(-1.0f);
  return p;
}
MF_FN MfPlane mf_plane_select(I mask, MfPlane a, MfPlane b) {
  MfPlane p;
  p.n = mf3_select(mask, a.n, b.n);
  p.d = mf_select(mask, a.d, b.d);
  return p;
}

// What one agent knows of another.
typedef struct {
  F3 line;      // m, from the agent to the other
  F3 approach;  // m/s, the agent's velocity less the other's
  F radius;     // m, the sum of both
  F3 parting;   // a unit vector where nothing else tells how to part: opposite for the two of a pair
} MfEncounter;

// How far `approach` is from leaving the velocity obstacle, m/s, along `n`: u of the paper is n times that.
typedef struct {
  F3 n;
  F change;
} MfEscape;

// The part of `parting` across the unit vector `axis`, made a unit vector.
MF_FN F3 mf_sideways(F3 parting, F3 axis) {
  // One that lies along the axis is turned first. Both steps give the two of a pair opposite vectors.
  const F along = mf3_dot(parting, axis);
  const F3 turned = mf3(-parting.y, parting.x, mf_splat(0.0f));
  const F3 from = mf3_select(along * along > mf_splat(0.75f), turned, parting);
  return mf3_unit(mf3_sub(from, mf3_scale(axis, mf3_dot(from, axis))));
}

// The shortest way out of the velocity obstacle that is cut off at `horizon` (s): a sphere of radius R/τ
// about line/τ, and the cone about the line that touches it. Two that overlap have `period` (s) to part.
// Along the cone the distance is taken from its axis rather than from the roots of a quadratic, which cancel.
MF_FN MfEscape mf_escape(const MfEncounter* e, F horizon, float period) {
  const F radius2 = e->radius * e->radius;
  const F distance2 = mf3_dot(e->line, e->line);
  const I overlap = distance2 <= radius2;
  const F rate = 1.0f / mf_select(overlap, mf_splat(period), horizon);
  const F3 w = mf3_sub(e->approach, mf3_scale(e->line, rate));
  const F ahead = mf3_dot(w, e->line);
  const I sphere = overlap | ((ahead < mf_splat(0.0f)) & (ahead * ahead > radius2 * mf3_dot(w, w)));
  const F away = 1.0f / mf_sqrt(mf_select(overlap, mf_splat(1.0f), distance2));
  const F3 axis = mf3_scale(e->line, away);
  const F along = mf3_dot(e->approach, axis);
  const F3 outwards = mf3_select(sphere, w, mf3_sub(e->approach, mf3_scale(axis, along)));
  const F length = mf3_length(outwards);
  const I lost = length < 1e-6f * mf_max(mf3_length(e->approach), mf_splat(1e-3f));
  F3 direction = mf3_scale(outwards, 1.0f / mf_select(lost, mf_splat(1.0f), length));
  if (mf_any(lost)) {
    const F3 side = mf3_select(sphere, e->parting, mf_sideways(e->parting, axis));
    direction = mf3_select(lost, side, direction);
  }
  const F sine = e->radius * away;
  const F cosine = mf_sqrt(mf_max(1.0f - sine * sine, mf_splat(0.0f)));
  MfEscape out;
  out.n = mf3_select(sphere, direction, mf3_sub(mf3_scale(direction, cosine), mf3_scale(axis, sine)));
  out.change = mf_select(sphere, e->radius * rate - length, along * sine - length * cosine);
  return out;
}

// v is what the agent was last told. It takes `share` of the change on itself: half where the other avoids
// collisions as well, else all of it.
MF_FN MfPlane mf_orca_plane(F3 v, const MfEncounter* e, F share, F horizon, float period) {
  const MfEscape escape = mf_escape(e, horizon, period);
  MfPlane p;
  p.n = escape.n;
  p.d = mf3_dot(escape.n, v) + share * escape.change;
  return p;
}

MF_END

#endif
