// The field model: V(x) = curl noise + guided velocity down the cost field, kept off walls (Wang14 §6,
// model.md §4).
#ifndef MAYFLY_KERNELS_FIELD_H
#define MAYFLY_KERNELS_FIELD_H

#include "kernels/boundary.h"
#include "kernels/bricks.h"
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
  float most_speed;              // m/s: nobody is led faster
  float slow_down;               // m over which the speed falls to 0 at an agent's place in its goal
  float goal_margin;             // m of depth over which an agent turns to that place
  MfFence fence;                 // of the goal at its first place: agents roam in it, none has a place there
  float radius;                  // m, of the body
  float low_x, low_y, low_z;     // m: the world's bounds, less the radius
  float high_x, high_y, high_z;  // m
  float goal_x, goal_y, goal_z;  // m: how far the goal has moved from where the rest places were laid
  float goal_vx, goal_vy, goal_vz;  // m/s: of the goal; who is in it moves with it
  float approach_rate;              // 1/s: an agent nears a wall no faster than this times its clearance
  int pulls;
  MfPull pull[MF_MAX_PULLS];
} MfField;

// The tables that a swarm flies by.
typedef struct {
  const MF_GLOBAL float* walls;                     // spline coefficients of φ (m) on field->grid
  const MF_GLOBAL float* guide;                     // 4 floats a cell of it
  const MF_GLOBAL float *rest_x, *rest_y, *rest_z;  // m, one an agent of the swarm: its place in the goal
  const MF_GLOBAL int* permutation;                 // Perlin's
} MfTables;

// From the centre of the fence, which moves with the goal, to r.
MF_FN F3 mf_from_fence(F3 r, const MfField* field) {
  const MfFence* fence = &field->fence;
  return mf3_sub(r, mf3_splat(fence->x + field->goal_x, fence->y + field->goal_y, fence->z + field->goal_z));
}

// V_g = −∇C/|∇C| · s0 (Wang14 Eq. 8). The guide holds a unit direction and C/A (m; inside the goal minus the
// depth) in each cell. Inside its goal an agent turns to its own place there and slows down towards it: a
// swarm fills its goal instead of piling up on its face, and does not oscillate through it. One that roams is
// led into its goal and no further: there the noise alone moves it. `agent` is its index in the swarm; `cost`
// becomes what the guide says of r, m.
MF_FN F3 mf_global_velocity(F3 r, I agent, const MfAround* around, const MfField* field,
                            const MfTables* tables, F* cost) {
  F guide[4];
  mf_around_sample4(tables->guide, around, &field->grid, guide);
  *cost = guide[3];
  const F3 down = mf3_unit(mf3(guide[0], guide[1], guide[2]));
  const F3 cruise = mf3_scale(down, mf_splat(field->cruise_speed));
  if (field->fence.kind != MF_FENCE_NONE) {
    // All at once: a field that fades below the border would hold noise back, and gather agents where it
    // does.
    const I outside = mf_fence_depth(mf_from_fence(r, field), &field->fence) < mf_splat(0.0f);
    return mf3_select(outside, cruise, mf3_splat(field->goal_vx, field->goal_vy, field->goal_vz));
  }
  const F inside = mf_ramp(-guide[3] * (1.0f / field->goal_margin));
  const I arrived = inside > mf_splat(0.0f);
  if (!mf_any(arrived)) return cruise;
  const F3 rest = mf3(mf_gather(tables->rest_x, agent), mf_gather(tables->rest_y, agent),
                      mf_gather(tables->rest_z, agent));
  const F3 place = mf3_add(rest, mf3_splat(field->goal_x, field->goal_y, field->goal_z));
  const F3 home = mf3_sub(place, r);
  const F3 direction = mf3_unit(mf3_add(mf3_scale(down, 1.0f - inside), mf3_scale(mf3_unit(home), inside)));
  const F slowed = mf_ramp(mf3_length(home) * (1.0f / field->slow_down));
  const F speed = field->cruise_speed * (1.0f - inside * (1.0f - slowed));
  const F3 carried = mf3_scale(mf3_splat(field->goal_vx, field->goal_vy, field->goal_vz), inside);
  return mf3_select(arrived, mf3_add(mf3_scale(direction, speed), carried), cruise);
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

// Whether a wall is nearer than `reach` (m, at most field->wall_reach; a nested grid answers for all of
// that). The coefficient of the nearest cell tells of most agents that none is: it differs from the
// interpolated one by little more than the way between them, 0.87 cells at the most.
MF_FN I mf_near_wall(const MfAround* around, F reach, const MfField* field, const MF_GLOBAL float* walls) {
  if (field->grid.nested) {
    return mf_place_near_wall(&around->place, walls, &around->corners, &field->grid, field->wall_reach);
  }
  const MfCube* cube = &around->cube;
  const F nearest = mf_gather(walls, mf_nearest_corner(cube));
  const I perhaps = nearest < reach + 1.25f * field->grid.cell;
  if (!mf_any(perhaps)) return perhaps;
  return perhaps & (mf_sample(walls, cube) < reach);
}

// How far off a wall may be that holds back an agent at v (m/s). The half cell is what interpolated
// coefficients may tell more than the spline.
MF_FN F mf_guard_reach(F3 v, const MfField* field) {
  const F to_stop = mf3_length(v) * (1.0f / field->approach_rate);
  return mf_min(to_stop + (field->radius + 0.5f * field->grid.cell), mf_splat(field->wall_reach));
}

// The guard alone, for velocities that were changed after the model gave them.
MF_FN F3 mf_field_guard(F3 r, F3 v, const MfField* field, const MF_GLOBAL float* walls) {
  const F3 inside = mf_guard_bounds(v, r, field);
  if (!field->has_walls) return inside;
  const MfAround around = mf_around(r, walls, &field->grid);
  const I near_wall = mf_near_wall(&around, mf_guard_reach(inside, field), field, walls);
  if (!mf_any(near_wall)) return inside;
  const MfSurface surface = mf_around_surface(r, &around, walls, &field->grid);
  return mf3_select(near_wall, mf_guard_wall(inside, &surface, field), inside);
}

// Guided velocity, pulls and the noises that do not know of walls: all that a wall only guards, and does not
// bend.
MF_FN F3 mf_steady_velocity(F3 r, I id, I agent, const MfAround* around, const MfField* field,
                            const MfMoment* moment, const MfTables* tables, F* cost) {
  F3 v = mf_global_velocity(r, agent, around, field, tables, cost);
  for (int k = 0; k < field->pulls; ++k) {
    v = mf3_add(v, mf_pull(r, id, &field->pull[k], moment, MF_STREAM_PULL + (uint)k));
  }
  if (field->has_noise && field->noise.kind != MF_NOISE_CURL) {
    v = mf3_add(v, mf_other_noise(r, id, &field->noise, moment, tables->permutation));
  }
  return v;
}

// Curl noise at r that leads no agent into a wall, nor one that roams out of its goal: of the two, whichever
// is nearer bends it. `surface` is read where any agent is near a wall.
MF_FN F3 mf_bent_noise(F3 r, I near_wall, const MfSurface* surface, const MfField* field,
                       const MfMoment* moment, const MF_GLOBAL int* permutation) {
  if (!field->has_noise || field->noise.kind != MF_NOISE_CURL) return mf3_splat(0.0f, 0.0f, 0.0f);
  const int fenced = field->fence.kind != MF_FENCE_NONE;
  const F3 line = mf_from_fence(r, field);
  F depth = mf_splat(1e9f);
  I at_border = mf_isplat(0);
  if (fenced) {
    const F below = mf_fence_depth(line, &field->fence);
    at_border = (below >= mf_splat(0.0f)) & (below < mf_splat(field->boundary));
    depth = mf_select(at_border, below, depth);
  }
  if (!mf_any(near_wall | at_border)) return mf_curl_noise_at(r, &field->noise, moment, permutation);
  const MfJet potential = mf_potential_at(r, &field->noise, moment, permutation);
  F3 noise = mf_curl(potential);
  if (fenced) {
    const F3 inside = mf_fenced_curl(&potential, line, &field->fence, field->boundary);
    noise = mf3_select(at_border, inside, noise);
  }
  if (!mf_any(near_wall)) return noise;
  const F3 outside = mf_bounded_curl(&potential, surface, field->boundary);
  return mf3_select(near_wall & (surface->value < depth), outside, noise);
}

// Eight agents of a swarm, named one after the other in `order`; beyond `lanes` the first of them again.
MF_FN I mf_swarm_agents(const MF_GLOBAL int* order, int lanes) {
  const I id = mf_iload(order);
  return mf_iselect(mf_lane_index() < mf_isplat(lanes), id, mf_isplat(order[0]));
}

// Whoever is faster than the limit keeps the direction. Before minimum distances are enforced, not after: a
// robot that cannot do what it was told comes to be on somebody else's place.
MF_FN F3 mf_within_speed(F3 v, float most) {
  const F squared = mf3_dot(v, v);
  const I fast = squared > mf_splat(most * most);
  if (!mf_any(fast)) return v;
  return mf3_select(fast, mf3_scale(mf3_unit(v), mf_splat(most)), v);
}

// Where no path leads to the goal an agent holds. The guide then says 1e9 m (fields/cost_field.hpp); a
// quarter of that will do, because in a corner of its cell an agent may have three neighbours with a way,
// beyond a wall.
#define MF_NO_WAY 2.5e8f

MF_FN F3 mf_going(F3 v, I lost) {
  if (!mf_any(lost)) return v;
  return mf3_select(lost, mf3_splat(0.0f, 0.0f, 0.0f), v);
}

// Agents whose place is no number are not there, and get no velocity.
MF_FN F3 mf_of_present(F3 r, F3 v) {
  const F place = r.x + r.y + r.z;
  const I here = (place < mf_splat(0.0f)) | (place >= mf_splat(0.0f));
  return mf3_select(here, v, mf3_splat(0.0f, 0.0f, 0.0f));
}

// The preferred velocity of eight agents at r (m), whose numbers in the whole flight are `id` and in their
// swarm `agent`.
MF_FN F3 mf_field_velocity(F3 r, I id, I agent, const MfField* field, const MfMoment* moment,
                           const MfTables* tables) {
  const MfAround around = mf_around(r, tables->walls, &field->grid);
  F cost;
  const F3 steady = mf_steady_velocity(r, id, agent, &around, field, moment, tables, &cost);
  const I lost = cost > mf_splat(MF_NO_WAY);
  I bends = mf_isplat(0);
  if (field->has_walls) {
    bends = mf_near_wall(&around, mf_splat(field->boundary + field->grid.cell), field, tables->walls);
  }
  const int is_bent = mf_any(bends);
  MfSurface surface;
  if (is_bent) surface = mf_around_surface(r, &around, tables->walls, &field->grid);
  const F3 noise = mf_bent_noise(r, bends, &surface, field, moment, tables->permutation);
  const F3 led = mf_within_speed(mf3_add(noise, steady), field->most_speed);
  const F3 v = mf_guard_bounds(mf_going(led, lost), r, field);
  if (!field->has_walls) return v;
  const I guards = mf_near_wall(&around, mf_guard_reach(v, field), field, tables->walls);
  if (!mf_any(guards)) return v;
  if (!is_bent) surface = mf_around_surface(r, &around, tables->walls, &field->grid);
  return mf3_select(guards, mf_guard_wall(v, &surface, field), v);
}

MF_END

#endif
