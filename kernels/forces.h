// The models that integrate forces: what drives eight agents, and the velocity they come to prefer. Plain
// structs: they travel to a kernel as arguments.
#ifndef MAYFLY_KERNELS_FORCES_H
#define MAYFLY_KERNELS_FORCES_H

#include "kernels/boids.h"
#include "kernels/brownian.h"
#include "kernels/field.h"
#include "kernels/zones.h"

MF_BEGIN

// Optimal reciprocal collision avoidance in three dimensions (van den Berg et al. 2011).
typedef struct {
  int on;
  float radius;        // m, of the body, margins included
  float horizon;       // s, against agents
  float wall_horizon;  // s, against obstacles
  float range;         // m, nobody farther is considered
  int neighbours;      // the nearest so many are, at most MF_MAX_NEIGHBOURS
  float most_speed;    // m/s
  int strict;          // 1: no two of them touch even in a jam, where both are strict; it slows a dense flock
} MfAvoidance;

#define MF_MAX_NEIGHBOURS 16

// Where and when eight agents fly, whatever drives them.
typedef struct {
  const MfField* field;
  const MfMoment* moment;
  const MF_GLOBAL float* walls;
  const MF_GLOBAL int* permutation;
  float period;  // s
  int guarded;   // whether walls and bounds hold agents back here, or avoidance does that later
} MfSetting;

// No faster than allowed, and through no wall. Absent agents get no velocity.
MF_FN F3 mf_preferred(F3 r, F3 v, const MfSetting* s) {
  F3 led = mf_within_speed(v, s->field->most_speed);
  if (s->guarded) led = mf_field_guard(r, led, s->field, s->walls);
  return mf_of_present(r, led);
}

// v + F · period.
MF_FN F3 mf_integrated(F3 v, F3 force, const MfSetting* s) {
  return mf3_add(v, mf3_scale(force, mf_splat(s->period)));
}

// F_noise, m/s²: the noise of the field model, as a force.
MF_FN F3 mf_noise_force(F3 r, I id, const MfSetting* s) {
  const MfNoise* noise = &s->field->noise;
  if (!s->field->has_noise) return mf3_splat(0.0f, 0.0f, 0.0f);
  if (noise->kind == MF_NOISE_CURL) return mf_curl_noise_at(r, noise, s->moment, s->permutation);
  return mf_other_noise(r, id, noise, s->moment, s->permutation);
}

// F_fric = −γ |v| v (BSwarm15 §4), m/s².
MF_FN F3 mf_friction(F3 v, float friction) {
  return mf3_scale(v, mf3_length(v) * -friction);
}

// Eight agents among the sorted.
typedef struct {
  F3 r, v;    // m, m/s
  I slot;     // their places there
  I id;       // their numbers in the flight
  int lanes;  // how many of the eight there are; the others repeat the first
} MfEight;

MF_FN MfEight mf_sorted_eight(const MfNeighbours* n, const MF_GLOBAL int* id, int first, int lanes) {
  const I own = mf_lane_index() < mf_isplat(lanes);
  MfEight e;
  e.lanes = lanes;
  e.slot = mf_iselect(own, mf_lane_index() + first, mf_isplat(first));
  e.id = mf_iselect(own, mf_iload(id + first), mf_isplat(id[first]));
  e.r = mf3(mf_select(own, mf_load(n->x + first), mf_splat(n->x[first])),
            mf_select(own, mf_load(n->y + first), mf_splat(n->y[first])),
            mf_select(own, mf_load(n->z + first), mf_splat(n->z[first])));
  e.v = mf3(mf_select(own, mf_load(n->vx + first), mf_splat(n->vx[first])),
            mf_select(own, mf_load(n->vy + first), mf_splat(n->vy[first])),
            mf_select(own, mf_load(n->vz + first), mf_splat(n->vz[first])));
  return e;
}

// Whom a swarm's agents may mind, and the mesh of their attraction.
typedef struct {
  MfCubes cubes;
  MfNeighbours neighbours;
  MfMesh mesh;
  const MF_GLOBAL float* nodes;  // four floats each
} MfCompany;

// F_int, m/s²; `aligning` is a literal at each call.
MF_FN F3 mf_zones_of(const MfEight* e, const MfForces* forces, const MfCompany* c, int aligning) {
  MfZoneSearch search;
  search.rep_squared = mf_splat(forces->rep_radius * forces->rep_radius);
  search.ali_squared = mf_splat(forces->ali_radius * forces->ali_radius);
  search.att_squared = mf_splat(forces->att_radius * forces->att_radius);
  search.r = e->r;
  search.v = e->v;
  const F3 in_mesh = mf_in_mesh(e->r, &c->mesh.cubes);
  const int meshed = c->mesh.on && mf_all(mf_within_mesh(in_mesh, &c->mesh.cubes));
  if (forces->att_weight != 0.0f && !meshed) {
    const MfZoneSums all = mf_zone_sums(&search, forces, &c->cubes, &c->neighbours, aligning, 1);
    return mf_zone_force(&all, all.att, mf_to_float(all.att_count), forces);
  }
  const MfZoneSums inner = mf_zone_sums(&search, forces, &c->cubes, &c->neighbours, aligning, 0);
  MfFar far;
  far.sum = mf3_splat(0.0f, 0.0f, 0.0f);
  far.count = mf_splat(0.0f);
  if (meshed) far = mf_far_between(in_mesh, c->nodes, &c->mesh.cubes);
  return mf_zone_force(&inner, far.sum, far.count, forces);
}

MF_FN F3 mf_interaction(const MfEight* e, const MfForces* forces, const MfCompany* c) {
  const int aligning = forces->ali_weight != 0.0f && forces->ali_radius > forces->rep_radius;
  return aligning ? mf_zones_of(e, forces, c, 1) : mf_zones_of(e, forces, c, 0);
}

// What agents remember of predators: see mf_stimuli_force. `key` is that of all encounters.
typedef struct {
  const MfMoment* key;
  MF_GLOBAL int* count;
  int first, agents;  // the swarm's own
} MfEncounters;

// The force model (BSwarm15 Eq. 2; model.md §5).
MF_FN F3 mf_forces_velocity(const MfEight* e, const MfForces* forces, const MfCompany* c,
                            const MfEncounters* met, const MfSetting* s) {
  F3 force = mf_interaction(e, forces, c);
  force = mf3_add(force, mf_friction(e->v, forces->friction));
  force = mf3_add(force, mf_stimuli_force(e->r, e->v, e->id, e->id - met->first, e->lanes, forces->stimulus,
                                          forces->stimuli, met->key, met->count, met->agents));
  force = mf3_add(force, mf_noise_force(e->r, e->id, s));
  return mf_preferred(e->r, mf_integrated(e->v, force, s), s);
}

// Turned by the flock, at the flock's speed.
MF_FN F3 mf_boids_velocity(const MfEight* e, const MfBoids* boids, const MfCompany* c, const MfSetting* s) {
  const MfFlock flock = mf_flock(e->r, e->v, e->slot, boids, &c->cubes, &c->neighbours);
  const F3 force = mf3_add(mf_flock_force(&flock, boids), mf_noise_force(e->r, e->id, s));
  const F3 turned = mf3_unit(mf_integrated(e->v, force, s));
  return mf_preferred(e->r, mf3_scale(turned, mf_splat(boids->speed)), s);
}

MF_FN F3 mf_brownian_velocity(const MfEight* e, const MfBrownian* b, const MfSetting* s) {
  F3 force = mf_brownian_force(e->r, e->v, b);
  force = mf3_add(force, mf_brownian_noise(e->id, b, s->moment, s->period));
  force = mf3_add(force, mf_noise_force(e->r, e->id, s));
  return mf_preferred(e->r, mf_integrated(e->v, force, s), s);
}

MF_END

#endif
