// How simulated robots answer a velocity command: three plants, stepped at a fixed time step.
#ifndef MAYFLY_KERNELS_PLANTS_H
#define MAYFLY_KERNELS_PLANTS_H

#include "kernels/lane.h"

// All robots of one plant are one block of floats: columns of `stride` floats each, in this order. `stride`
// is a multiple of MF_LANES; unused robots are zero.
#define MF_PLANT_X 0                  // x, y, z: m
#define MF_PLANT_VX 3                 // vx, vy, vz: m/s
#define MF_PLANT_UX 6                 // ux, uy, uz: the commanded velocity, m/s
#define MF_PLANT_MAX_SPEED 9          // m/s, may be infinite
#define MF_PLANT_MAX_ACCELERATION 10  // m/s², may be infinite
#define MF_PLANT_COLUMNS 11

#define MF_PLANT_IDEAL 0
#define MF_PLANT_VELOCITY_LAG 1
#define MF_PLANT_DOUBLE_INTEGRATOR 2

MF_BEGIN

typedef struct {
  float dt;     // s, one step
  float decay;  // exp(−dt/τ), from the host: lanes know no exponential
  float reach;  // τ·(1 − decay), s: how far a metre per second of difference still carries
  int steps;    // how many to take in one launch
} MfPlant;

typedef struct {
  F3 p;  // m
  F3 v;  // m/s
} MfMotion;

// v, shortened to `most` where it is longer. The division is only looked at where |v| > most.
MF_FN F3 mf_shorten(F3 v, F most) {
  const F squared = mf3_dot(v, v);
  const I longer = squared > most * most;
  return mf3_select(longer, mf3_scale(v, most / mf_sqrt(squared)), v);
}

MF_FN F3 mf_trapezoid(F3 p, F3 v0, F3 v1, float dt) {
  return mf3_add(p, mf3_scale(mf3_add(v0, v1), mf_splat(0.5f * dt)));
}

// The command at once: v⁺ = u, whatever acceleration that takes.
MF_FN MfMotion mf_step_ideal(MfMotion s, F3 u, MfPlant plant) {
  s.p = mf3_add(s.p, mf3_scale(u, mf_splat(plant.dt)));
  s.v = u;
  return s;
}

// The acceleration-limited one: v goes straight towards u, |v⁺ − v| ≤ most.
MF_FN MfMotion mf_step_double_integrator(MfMotion s, F3 u, F most, MfPlant plant) {
  const F3 v = mf3_add(s.v, mf_shorten(mf3_sub(u, s.v), most));
  s.p = mf_trapezoid(s.p, s.v, v, plant.dt);
  s.v = v;
  return s;
}

// τ dv/dt = u − v, solved exactly over a step in which u is constant, position as well. A robot has only so
// much thrust: where the exact answer needs |v⁺ − v| > most, it accelerates as hard as it can instead.
MF_FN MfMotion mf_step_velocity_lag(MfMotion s, F3 u, F most, MfPlant plant) {
  const F3 behind = mf3_sub(s.v, u);
  const F3 wanted = mf3_add(u, mf3_scale(behind, mf_splat(plant.decay)));
  const F3 change = mf3_sub(wanted, s.v);
  const I too_hard = mf3_dot(change, change) > most * most;
  const F3 limited = mf3_add(s.v, mf_shorten(change, most));
  const F3 exact =
      mf3_add(mf3_add(s.p, mf3_scale(u, mf_splat(plant.dt))), mf3_scale(behind, mf_splat(plant.reach)));
  s.p = mf3_select(too_hard, mf_trapezoid(s.p, s.v, limited, plant.dt), exact);
  s.v = mf3_select(too_hard, limited, wanted);
  return s;
}

MF_FN F3 mf_load3(const MF_GLOBAL float* column, int stride) {
  return mf3(mf_load(column), mf_load(column + stride), mf_load(column + 2 * stride));
}
MF_FN void mf_store3(MF_GLOBAL float* column, int stride, F3 v) {
  mf_store(column, v.x);
  mf_store(column + stride, v.y);
  mf_store(column + 2 * stride, v.z);
}

// Takes plant.steps steps with the eight robots from `first` on. `kind` is a literal at each call, so that
// the choice costs nothing.
MF_FN void mf_run_plant(MF_GLOBAL float* block, int stride, int first, MfPlant plant, int kind) {
  MF_GLOBAL float* const robots = block + first;
  const F fastest = mf_load(robots + MF_PLANT_MAX_SPEED * stride);
  const F most = mf_load(robots + MF_PLANT_MAX_ACCELERATION * stride) * mf_splat(plant.dt);
  const F3 u = mf_shorten(mf_load3(robots + MF_PLANT_UX * stride, stride), fastest);
  MfMotion s;
  s.p = mf_load3(robots + MF_PLANT_X * stride, stride);
  s.v = mf_load3(robots + MF_PLANT_VX * stride, stride);
  for (int step = 0; step < plant.steps; ++step) {
    if (kind == MF_PLANT_IDEAL) {
      s = mf_step_ideal(s, u, plant);
    } else if (kind == MF_PLANT_VELOCITY_LAG) {
      s = mf_step_velocity_lag(s, u, most, plant);
    } else {
      s = mf_step_double_integrator(s, u, most, plant);
    }
  }
  mf_store3(robots + MF_PLANT_X * stride, stride, s.p);
  mf_store3(robots + MF_PLANT_VX * stride, stride, s.v);
}

MF_END

#endif
