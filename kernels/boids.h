// Flocks after Reynolds (1987), for comparisons: separation, alignment and cohesion, at a speed of its own.
#ifndef MAYFLY_KERNELS_BOIDS_H
#define MAYFLY_KERNELS_BOIDS_H

#include "kernels/neighbours.h"

MF_BEGIN

// Radii in m. Flown at `speed` m/s.
typedef struct {
  float separation_weight;  // m/s²
  float alignment_weight;   // 1/s
  float cohesion_weight;    // 1/s²
  float separation_radius, alignment_radius, cohesion_radius;
  float speed;
} MfBoids;

// Over the neighbours nearer than each radius: Σ −r̂ (1 − r/radius), Σ v and Σ r (relative to the agent), and
// how many they are.
typedef struct {
  F3 apart, velocity, place;
  I apart_count, velocity_count, place_count;
} MfFlock;

// Neighbours first … past − 1 of the agents in `slot`.
MF_FN void mf_add_flock(MfFlock* flock, F3 r, F3 v, I slot, const MfBoids* b, const MfNeighbours* n,
                        int first, int past) {
  const F separation = mf_splat(b->separation_radius * b->separation_radius);
  const F alignment = mf_splat(b->alignment_radius * b->alignment_radius);
  const F cohesion = mf_splat(b->cohesion_radius * b->cohesion_radius);
  const float per_radius = b->separation_radius > 0.0f ? 1.0f / b->separation_radius : 0.0f;
  for (int j = first; j < past; ++j) {
    const F3 line = mf3_sub(mf3_splat(n->x[j], n->y[j], n->z[j]), r);
    const F squared = mf3_dot(line, line);
    const I other = slot != mf_isplat(j);
    const I aligned = (squared < alignment) & other;
    const I cohesive = (squared < cohesion) & other;
    const I near_one = (squared < separation) & other;
    const F3 faster = mf3_sub(mf3_splat(n->vx[j], n->vy[j], n->vz[j]), v);
    flock->velocity = mf3_add(flock->velocity, mf3_kept(aligned, faster));
    flock->place = mf3_add(flock->place, mf3_kept(cohesive, line));
    flock->velocity_count -= aligned;
    flock->place_count -= cohesive;
    // r̂ (1 − r/R) = r⃗ (1/r − 1/R)
    const I some = squared >= mf_splat(MF_TINY_SQUARED);
    const F push = mf_kept(near_one & some, mf_inverse_root(squared) - per_radius);
    flock->apart = mf3_sub(flock->apart, mf3_scale(line, push));
    flock->apart_count -= near_one;
  }
}

MF_FN MfFlock mf_flock(F3 r, F3 v, I slot, const MfBoids* b, const MfCubes* c, const MfNeighbours* n) {
  MfFlock flock;
  flock.apart = flock.velocity = flock.place = mf3_splat(0.0f, 0.0f, 0.0f);
  flock.apart_count = flock.velocity_count = flock.place_count = mf_isplat(0);
  float reach = b->separation_radius > b->alignment_radius ? b->separation_radius : b->alignment_radius;
  reach = (reach > b->cohesion_radius ? reach : b->cohesion_radius) * c->inverse;
  const MfBox box = mf_box_around(r, c);
  const int y_first = mf_first_cube(box.low_y, reach, c->cells_y);
  const int y_last = mf_last_cube(box.high_y, reach, c->cells_y);
  const int z_last = mf_last_cube(box.high_z, reach, c->cells_z);
  for (int z = mf_first_cube(box.low_z, reach, c->cells_z); z <= z_last; ++z) {
    for (int y = y_first; y <= y_last; y += MF_LANES) {
      const MfRows rows = mf_rows(&box, y, z, reach, c);
      const MF_GLOBAL int* row = n->start + (z * c->cells_y + y) * c->cells_x;
      for (int k = 0; k < MF_LANES && y + k <= y_last; ++k, row += c->cells_x) {
        mf_add_flock(&flock, r, v, slot, b, n, row[rows.first[k]], row[rows.past[k]]);
      }
    }
  }
  return flock;
}

// Acceleration, m/s².
MF_FN F3 mf_flock_force(const MfFlock* flock, const MfBoids* b) {
  const I one = mf_isplat(1);
  const F apart = b->separation_weight / mf_to_float(mf_imax(flock->apart_count, one));
  const F along = b->alignment_weight / mf_to_float(mf_imax(flock->velocity_count, one));
  const F together = b->cohesion_weight / mf_to_float(mf_imax(flock->place_count, one));
  return mf3_add(mf3_add(mf3_scale(flock->apart, apart), mf3_scale(flock->velocity, along)),
                 mf3_scale(flock->place, together));
}

MF_END

#endif
