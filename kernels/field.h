// The field model: V(x) = curl noise + guided velocity down the cost field, kept off walls (Wang14 §6,
// model.md §4).
#ifndef MAYFLY_KERNELS_FIELD_H
#define MAYFLY_KERNELS_FIELD_H

#include "kernels/boundary.h"
#include "kernels/fence.h"
#include "kernels/pull.h"
#include "kernels/random_noise.h"

MF_BEGIN

// What one swarm flies by. Plain numbers: it travels to a kernel as an argument.
typedef struct {
  MfGrid grid;
  MfNoise noise;
  int has_noise;
  int has_walls;
  float boundary;                // m, d0
  float wall_reach;              // m: further out than this nothing of a wall is felt
  float cruise_speed;            // m/s, s0
  float slow_down;               // m over which the speed falls to 0 at an agent's place in its goal
  float goal_margin;             // m of depth over which an agent turns to that place
  MfFence fence;                 // of the goal at its first place: agents roam in it, none has a place there
  float radius;                  // m, of the body
  float low_x, low_y, low_z;     // m: the world's bounds, less the radius
  float high_x, high_y, high_z;  // m
  float goal_x, goal_y, goal_z;  // m: how far the goal has moved from where the rest places were laid
  float approach_rate;           // 1/s: an agent nears a wall no faster than this times its clearance
  int pulls;
  MfPull pull[MF_MAX_PULLS];
} MfField;

// From the centre of the fence, which moves with the goal, to r.
MF_FN F3 mf_from_fence(F3 r, const MfField* field) {
  const MfFence* fence = &field->fence;
  return mf3_sub(r, mf3_splat(fence->x + field->goal_x, fence->y + field->goal_y, fence->z + field->goal_z));
}

// V_g = −∇C/|∇C| · s0 (Wang14 Eq. 8). The guide holds a unit direction and C/A (m; inside the goal minus the
// depth) in each cell. Inside its goal an agent turns to its own place there and slows down towards it: a
// swarm fills its goal instead of piling up on its face, and does not oscillate through it. One that roams is
// led into its goal and no further: there the noise alone moves it.
MF_FN F3 mf_global_velocity(F3 r, F3 rest, const MfCube* cube, const MF_GLOBAL float* guide,
                            const MfField* field) {
  const F3 down =
      mf3_unit(mf3(mf_sample(guide, cube, 4, 0), mf_sample(guide, cube, 4, 1), mf_sample(guide, cube, 4, 2)));
  if (field->fence.kind != MF_FENCE_NONE) {
    // All at once: a field that fades below the border would hold noise back, and gather agents where it
    // does.
    const I outside = mf_fence_depth(mf_from_fence(r, field), &field->fence) < mf_splat(0.0f);
    return mf3_scale(down, mf_select(outside, mf_splat(field->cruise_speed), mf_splat(0.0f)));
  }
  const F depth = -mf_sample(guide, cube, 4, 3);
  const F inside = mf_ramp(depth * (1.0f / field->goal_margin));
  const F3 home = mf3_sub(rest, r);
  const F3 direction = mf3_unit(mf3_add(mf3_scale(down, 1.0f - inside), mf3_scale(mf3_unit(home), inside)));
  const F slowed = mf_ramp(mf3_length(home) * (1.0f / field->slow_down));
  return mf3_scale(direction, field->cruise_speed * (1.0f - inside * (1.0f - slowed)));
}

// Limits the speed at which v approaches a wall to approach_rate × clearance, and leads out of the body's own
// radius.
MF_FN F3 mf_guard_wall(F3 v, const MfSurface* s, const MfField* field) {
  const F3 n = mf3_unit(s->gradient);
  const F slowest = -(s->value - field->radius) * field->approach_rate;
  const F lack = mf_max(slowest - mf3_dot(v, n), mf_splat(0.0f));
  return mf3_add(v, mf3_scale(n, lack));
}

// The same for the world's bounds, axis by axis: at a bound an agent slides along it instead of pressing
// against the fence.
MF_FN F3 mf_guard_bounds(F3 v, F3 r, const MfField* field) {
  const float rate = field->approach_rate;
  const F3 least = mf3_scale(mf3_sub(mf3_splat(field->low_x, field->low_y, field->low_z), r), mf_splat(rate));
  const F3 most =
      mf3_scale(mf3_sub(mf3_splat(field->high_x, field->high_y, field->high_z), r), mf_splat(rate));
  return mf3(mf_min(mf_max(v.x, least.x), most.x), mf_min(mf_max(v.y, least.y), most.y),
             mf_min(mf_max(v.z, least.z), most.z));
}

// The guard alone, for velocities that were changed after the model gave them.
MF_FN F3 mf_field_guard(F3 r, F3 v, const MfField* field, const MF_GLOBAL float* walls) {
  const F3 inside = mf_guard_bounds(v, r, field);
  if (!field->has_walls) return inside;
  const MfCube cube = mf_cube(r, &field->grid);
  const I near_wall = mf_sample(walls, &cube, 1, 0) < mf_splat(field->wall_reach);
  if (!mf_any(near_wall)) return inside;
  const MfSurface surface = mf_surface(r, walls, &field->grid);
  return mf3_select(near_wall, mf_guard_wall(inside, &surface, field), inside);
}

// Guided velocity and pulls: all that a wall only guards, and does not bend.
MF_FN F3 mf_steady_velocity(F3 r, F3 rest, I id, const MfCube* cube, const MfField* field,
                            const MfMoment* moment, const MF_GLOBAL float* guide) {
  F3 v = mf_global_velocity(r, rest, cube, guide, field);
  for (int k = 0; k < field->pulls; ++k) {
    v = mf3_add(v, mf_pull(r, id, &field->pull[k], moment, MF_STREAM_PULL + (uint)k));
  }
  return v;
}

// Curl noise at r, which leads no agent that roams out of its goal. `depth` (m) below the goal's border is
// told for whoever must choose between that border and a wall; far from either, and without a fence, it is
// large.
MF_FN F3 mf_free_noise(F3 r, const MfField* field, const MfMoment* moment, const MF_GLOBAL int* table,
                       F* depth) {
  const F3 noise = mf_curl_noise_at(r, &field->noise, moment, table);
  *depth = mf_splat(1e9f);
  if (field->fence.kind == MF_FENCE_NONE) return noise;
  const F3 line = mf_from_fence(r, field);
  const F below = mf_fence_depth(line, &field->fence);
  const I at_border = (below >= mf_splat(0.0f)) & (below < mf_splat(field->boundary));
  if (!mf_any(at_border)) return noise;
  *depth = mf_select(at_border, below, *depth);
  const MfJet potential = mf_potential_at(r, &field->noise, moment, table);
  return mf3_select(at_border, mf_fenced_curl(&potential, line, &field->fence, field->boundary), noise);
}

// The preferred velocity of eight agents at r (m), whose numbers in the whole flight are `id`. walls: spline
// coefficients of φ (m), guide: 4 floats a cell, both on field->grid; table: Perlin's permutation. The
// coefficients themselves, interpolated, tell well enough whether a wall is anywhere near.
MF_FN F3 mf_field_velocity(F3 r, F3 rest, I id, const MfField* field, const MfMoment* moment,
                           const MF_GLOBAL float* walls, const MF_GLOBAL float* guide,
                           const MF_GLOBAL int* table) {
  const MfCube cube = mf_cube(r, &field->grid);
  const F3 place = mf3_add(rest, mf3_splat(field->goal_x, field->goal_y, field->goal_z));
  F3 steady = mf_steady_velocity(r, place, id, &cube, field, moment, guide);
  F3 noise = mf3_splat(0.0f, 0.0f, 0.0f);
  F depth = mf_splat(0.0f);
  const int curls = field->has_noise && field->noise.kind == MF_NOISE_CURL;
  if (curls) {
    noise = mf_free_noise(r, field, moment, table, &depth);
  } else if (field->has_noise) {
    steady = mf3_add(steady, mf_other_noise(r, id, &field->noise, moment, table));
  }
  F3 v = mf_guard_bounds(mf3_add(noise, steady), r, field);
  if (!field->has_walls) return v;
  const I near_wall = mf_sample(walls, &cube, 1, 0) < mf_splat(field->wall_reach);
  if (!mf_any(near_wall)) return v;
  const MfSurface surface = mf_surface(r, walls, &field->grid);
  if (curls) {
    const MfJet potential = mf_potential_at(r, &field->noise, moment, table);
    noise = mf3_select(surface.value < depth, mf_bounded_curl(&potential, &surface, field->boundary), noise);
  }
  return mf3_select(near_wall,
                    mf_guard_wall(mf_guard_bounds(mf3_add(noise, steady), r, field), &surface, field), v);
}

MF_END

#endif
