// Optimal reciprocal collision avoidance in three dimensions (van den Berg et al. 2011; model.md §5): the
// velocity nearest to the preferred one that keeps an agent clear of its neighbours, of walls and of the
// world's bounds.
#ifndef MAYFLY_KERNELS_ORCA_H
#define MAYFLY_KERNELS_ORCA_H

#include "kernels/field.h"
#include "kernels/orca_fallback.h"

MF_BEGIN

// All agents that are there, in the order in which they were sorted by cell. `body` holds four floats each:
// its place (m) and radius (m); `motion` four more: what it was last told (m/s), and 1 if it avoids
// collisions, else 0. `nearest` holds `stride` sorted numbers for each: its neighbours, nearest first, then
// -1.
typedef struct {
  const MF_GLOBAL float* body;
  const MF_GLOBAL float* motion;
  const MF_GLOBAL int* id;  // the agent's number in the flight
  const MF_GLOBAL int* nearest;
  int stride;
} MfMinded;

typedef struct {
  F3 r;      // m
  F radius;  // m
  F3 v;      // m/s
  F avoids;
} MfBody;

MF_FN MfBody mf_body(const MfMinded* all, I slot) {
  F place[4];
  F motion[4];
  mf_gather4(all->body, slot * 4, place);
  mf_gather4(all->motion, slot * 4, motion);
  MfBody b;
  b.r = mf3(place[0], place[1], place[2]);
  b.radius = place[3];
  b.v = mf3(motion[0], motion[1], motion[2]);
  b.avoids = motion[3];
  return b;
}

// A half-space along `n` that lets an agent near what is `clearance` (m) away no faster than rate ×
// clearance, and a drift (m/s) of that; nearer than nothing, it leads out, at half the greatest speed at
// most: two or three such can be kept at once. Who cannot come near has none.
MF_FN void mf_add_clearance(MfPlanes* c, F3 n, F clearance, F rate, F drift, float most) {
  const F d = mf_min(drift - clearance * rate, mf_splat(0.5f * most));
  const I binds = d > mf_splat(-most);
  if (!mf_any(binds)) return;
  MfPlane p;
  p.n = n;
  p.d = d;
  c->plane[c->count++] = mf_plane_select(binds, p, mf_no_plane());
}

// The nearer of the two bounds along one axis.
MF_FN void mf_add_bound(MfPlanes* c, F at, float low, float high, F3 axis, float rate, float most) {
  const F below = at - low;
  const F above = high - at;
  const F sign = mf_select(below < above, mf_splat(1.0f), mf_splat(-1.0f));
  mf_add_clearance(c, mf3_scale(axis, sign), mf_min(below, above), mf_splat(rate), mf_splat(0.0f), most);
}

// The world's bounds and the nearest obstacle. An agent is let near them no faster than the field model's
// guard lets it, so that the guard, which comes last, finds nothing to mend.
MF_FN void mf_add_surroundings(MfPlanes* c, F3 r, const MfAvoidance* a, const MfField* field,
                               const MF_GLOBAL float* walls) {
  const float wanted = 1.0f / a->wall_horizon;
  const float rate = wanted < field->approach_rate ? wanted : field->approach_rate;
  mf_add_bound(c, r.x, field->low_x, field->high_x, mf3_splat(1.0f, 0.0f, 0.0f), rate, a->most_speed);
  mf_add_bound(c, r.y, field->low_y, field->high_y, mf3_splat(0.0f, 1.0f, 0.0f), rate, a->most_speed);
  mf_add_bound(c, r.z, field->low_z, field->high_z, mf3_splat(0.0f, 0.0f, 1.0f), rate, a->most_speed);
  if (!field->has_walls) return;
  const MfAround around = mf_around(r, walls, &field->grid);
  const float felt = a->most_speed / rate + a->radius + 0.5f * field->grid.cell;
  const F reach = mf_splat(felt < field->wall_reach ? felt : field->wall_reach);
  const I near_wall = mf_near_wall(&around, reach, field, walls);
  if (!mf_any(near_wall)) return;
  const MfSurface surface = mf_around_surface(r, &around, walls, &field->grid);
  const F clearance = mf_select(near_wall, surface.value - a->radius, mf_splat(1e9f));
  mf_add_clearance(c, mf3_unit(surface.gradient), clearance, mf_splat(rate), mf_splat(0.0f), a->most_speed);
}

typedef struct {
  I there;
  MfEncounter e;
  F3 v;     // m/s, the other's
  F share;  // of the way out that is the agent's own
} MfNeighbour;

// The k-th nearest of each of eight agents.
MF_FN MfNeighbour mf_neighbour(int k, I slot, const MfBody* self, const MfMinded* all) {
  const I other = mf_igather(all->nearest, slot * all->stride + k);
  MfNeighbour n;
  n.there = other >= mf_isplat(0);
  const I from = mf_iselect(n.there, other, slot);
  const MfBody b = mf_body(all, from);
  n.e.line = mf3_sub(b.r, self->r);
  n.e.approach = mf3_sub(self->v, b.v);
  n.e.radius = self->radius + b.radius;
  n.e.parting = mf_parting(mf_igather(all->id, slot), mf_igather(all->id, from));
  n.v = b.v;
  n.share = 1.0f - 0.5f * b.avoids;
  return n;
}

// Each of two takes no more than half of the gap between them before the next tick, whatever the other does:
// both may always stand still. From one that does not avoid an agent keeps the whole gap, as it moves.
MF_FN void mf_add_gaps(MfPlanes* c, I slot, const MfBody* self, const MfMinded* all, const MfAvoidance* a,
                       float period) {
  for (int k = 0; k < a->neighbours; ++k) {
    const MfNeighbour b = mf_neighbour(k, slot, self, all);
    if (!mf_any(b.there)) break;
    const F distance = mf3_length(b.e.line);
    const I same_place = distance < mf_splat(1e-9f);
    const F3 away = mf3_select(same_place, b.e.parting, mf3_unit(mf3_scale(b.e.line, mf_splat(-1.0f))));
    const F gap = mf_select(b.there, distance - b.e.radius, mf_splat(1e9f));
    const F drift = mf_select(b.share > mf_splat(0.75f), mf3_dot(b.v, away), mf_splat(0.0f));
    mf_add_clearance(c, away, gap, b.share * (1.0f / period), drift, a->most_speed);
  }
}

// One half-space a neighbour, nearest first.
MF_FN void mf_add_neighbours(MfPlanes* c, I slot, const MfBody* self, const MfMinded* all,
                             const MfAvoidance* a, float period) {
  for (int k = 0; k < a->neighbours; ++k) {
    const MfNeighbour b = mf_neighbour(k, slot, self, all);
    if (!mf_any(b.there)) break;
    const MfPlane p = mf_orca_plane(self->v, &b.e, b.share, mf_splat(a->horizon), period);
    c->plane[c->count++] = mf_plane_select(b.there, p, mf_no_plane());
  }
}

// How much of its speed an agent in somebody's way wishes to the side.
#define MF_SIDE 0.03f

// Where the way is barred, the wish leans to the agent's right and a little up or down, as its number has it:
// two that come upon each other head-on would stop and wait for ever.
MF_FN F3 mf_lean(F3 wish, I id, const MfPlanes* c, F slack) {
  I barred = mf_isplat(0);
  for (int i = c->hard; i < c->count; ++i) barred = barred | mf_breaks(&c->plane[i], wish, slack);
  if (!mf_any(barred)) return wish;
  const F speed2 = mf3_dot(wish, wish);
  const I steep = wish.z * wish.z > 0.9f * speed2;
  const F none = mf_splat(0.0f);
  const F3 right = mf3_unit(mf3_select(steep, mf3(none, wish.z, -wish.y), mf3(wish.y, -wish.x, none)));
  const F3 across = mf3_cross(right, wish);
  const U word = mf_mix(mf_to_unsigned(id) * 0x9e3779b9u);
  const F tilt = mf_to_float(mf_to_signed(word & 255u)) * (2.0f / 255.0f) - 1.0f;
  const F3 side = mf3_add(mf3_scale(right, mf_sqrt(speed2)), mf3_scale(across, tilt));
  return mf3_select(barred, mf3_add(wish, mf3_scale(side, mf_splat(MF_SIDE))), wish);
}

// What comes of eight agents.
typedef struct {
  F3 v;          // m/s
  I infeasible;  // no velocity kept them clear of everybody
} MfAvoided;

// The eight sorted agents `slot`, which prefer `wish` (m/s), of one swarm. `period` (s) is the tick's.
MF_FN MfAvoided mf_avoid(I slot, F3 wish, const MfMinded* all, const MfAvoidance* a, const MfField* field,
                         const MF_GLOBAL float* walls, float period) {
  const MfBody self = mf_body(all, slot);
  MfPlanes planes;
  planes.count = 0;
  mf_add_surroundings(&planes, self.r, a, field, walls);
  planes.firm = planes.count;
  if (a->strict) mf_add_gaps(&planes, slot, &self, all, a, period);
  planes.hard = planes.count;
  mf_add_neighbours(&planes, slot, &self, all, a, period);
  const F slack = mf_splat(1e-5f * a->most_speed);
  const MfGoal goal = {mf_lean(wish, mf_igather(all->id, slot), &planes, slack), 0, mf_splat(a->most_speed),
                       slack};
  I fails;
  MfAvoided out;
  out.v = mf_best_in_space(&planes, planes.count, &goal, mf_isplat(-1), &fails);
  out.infeasible = fails < mf_isplat(planes.count);
  if (mf_any(out.infeasible)) {
    out.v = mf_least_violation(&planes, out.v, fails, goal.most, slack);
  }
  out.v = mf_guard_bounds(out.v, self.r, field);
  return out;
}

MF_END

#endif
