// The models that integrate forces, for one swarm: eight agents a work item.
#include "kernels/forces.h"

// The agents are sorted by the cells of `cubes` (start; the columns x … vz are `stride` apart in `sorted`,
// readable eight elements past their end); work item g takes those from eights[g] to eights[g + 1] − 1, at
// most eight. Velocities are written in the agents' order.
#define MF_COMPANY_ARGUMENTS                                                                                 \
  __global const int *eights, const int count, const MfCubes cubes, __global const int *start,               \
      __global const float *sorted, const int stride, __global const int *id, __global const MfField *where, \
      const MfMoment moment, __global const float *walls, __global const int *permutation,                   \
      const float period_s, const int guarded, __global float *out_x, __global float *out_y,                 \
      __global float *out_z

#define MF_COMPANY_BEGIN                                                              \
  const int item = (int)get_global_id(0);                                             \
  if (item >= count) return;                                                          \
  const MfField field = *where;                                                       \
  const MfSetting setting = {&field, &moment, walls, permutation, period_s, guarded}; \
  MfCompany company;                                                                  \
  company.cubes = cubes;                                                              \
  company.neighbours.start = start;                                                   \
  company.neighbours.x = sorted;                                                      \
  company.neighbours.y = sorted + stride;                                             \
  company.neighbours.z = sorted + 2 * stride;                                         \
  company.neighbours.vx = sorted + 3 * stride;                                        \
  company.neighbours.vy = sorted + 4 * stride;                                        \
  company.neighbours.vz = sorted + 5 * stride;                                        \
  const MfEight e = mf_sorted_eight(&company.neighbours, id, eights[item], eights[item + 1] - eights[item])

MF_FN void mf_tell(const MfEight* e, F3 v, __global float* out_x, __global float* out_y,
                   __global float* out_z) {
  mf_scatter(out_x, e->id, v.x, e->lanes);
  mf_scatter(out_y, e->id, v.y, e->lanes);
  mf_scatter(out_z, e->id, v.z, e->lanes);
}

__kernel void forces_velocity(MF_COMPANY_ARGUMENTS, __global const MfForces* model, const MfMoment key,
                              __global int* encounters, const int first, const int agents, const MfMesh mesh,
                              __global const float* nodes) {
  MF_COMPANY_BEGIN;
  company.mesh = mesh;
  company.nodes = nodes;
  const MfForces forces = *model;
  const MfEncounters met = {&key, encounters, first, agents};
  mf_tell(&e, mf_forces_velocity(&e, &forces, &company, &met, &setting), out_x, out_y, out_z);
}

__kernel void boids_velocity(MF_COMPANY_ARGUMENTS, const MfBoids boids) {
  MF_COMPANY_BEGIN;
  mf_tell(&e, mf_boids_velocity(&e, &boids, &company, &setting), out_x, out_y, out_z);
}

__kernel void brownian_velocity(MF_COMPANY_ARGUMENTS, const MfBrownian brownian) {
  MF_COMPANY_BEGIN;
  mf_tell(&e, mf_brownian_velocity(&e, &brownian, &setting), out_x, out_y, out_z);
}
