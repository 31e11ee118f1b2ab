// The models that integrate forces, for one swarm: eight agents a work item.
#include "kernels/forces.h"

// The agents are sorted by the cells of `cubes` (start; the columns are readable eight elements past their
// end); work item g takes those from eights[g] to eights[g + 1] − 1, at most eight. Velocities are written in
// the agents' order.
__kernel void forces_velocity(__global const int* eights, const int count, const MfCubes cubes,
                              __global const int* start, __global const float* x, __global const float* y,
                              __global const float* z, __global const float* vx, __global const float* vy,
                              __global const float* vz, __global const int* id,
                              __global const MfForces* model, const MfMoment key, __global int* encounters,
                              const int first, const int agents, __global const MfField* where,
                              const MfMoment moment, __global const float* walls,
                              __global const int* permutation, const float period_s, const int guarded,
                              __global float* out_x, __global float* out_y, __global float* out_z) {
  const int item = (int)get_global_id(0);
  if (item >= count) return;
  const MfForces forces = *model;
  const MfField field = *where;
  const MfSetting setting = {&field, &moment, walls, permutation, period_s, guarded};
  const MfNeighbours neighbours = {start, x, y, z, vx, vy, vz};
  const MfEncounters met = {&key, encounters, first, agents};
  const MfEight e = mf_sorted_eight(&neighbours, id, eights[item], eights[item + 1] - eights[item]);
  const F3 v = mf_forces_velocity(&e, &forces, &cubes, &neighbours, &met, &setting);
  mf_scatter(out_x, e.id, v.x, e.lanes);
  mf_scatter(out_y, e.id, v.y, e.lanes);
  mf_scatter(out_z, e.id, v.z, e.lanes);
}

__kernel void boids_velocity(__global const int* eights, const int count, const MfCubes cubes,
                             __global const int* start, __global const float* x, __global const float* y,
                             __global const float* z, __global const float* vx, __global const float* vy,
                             __global const float* vz, __global const int* id, const MfBoids boids,
                             __global const MfField* where, const MfMoment moment,
                             __global const float* walls, __global const int* permutation,
                             const float period_s, const int guarded, __global float* out_x,
                             __global float* out_y, __global float* out_z) {
  const int item = (int)get_global_id(0);
  if (item >= count) return;
  const MfField field = *where;
  const MfSetting setting = {&field, &moment, walls, permutation, period_s, guarded};
  const MfNeighbours neighbours = {start, x, y, z, vx, vy, vz};
  const MfEight e = mf_sorted_eight(&neighbours, id, eights[item], eights[item + 1] - eights[item]);
  const F3 v = mf_boids_velocity(&e, &boids, &cubes, &neighbours, &setting);
  mf_scatter(out_x, e.id, v.x, e.lanes);
  mf_scatter(out_y, e.id, v.y, e.lanes);
  mf_scatter(out_z, e.id, v.z, e.lanes);
}

__kernel void brownian_velocity(__global const int* eights, const int count, const MfCubes cubes,
                                __global const int* start, __global const float* x, __global const float* y,
                                __global const float* z, __global const float* vx, __global const float* vy,
                                __global const float* vz, __global const int* id, const MfBrownian brownian,
                                __global const MfField* where, const MfMoment moment,
                                __global const float* walls, __global const int* permutation,
                                const float period_s, const int guarded, __global float* out_x,
                                __global float* out_y, __global float* out_z) {
  const int item = (int)get_global_id(0);
  if (item >= count) return;
  const MfField field = *where;
  const MfSetting setting = {&field, &moment, walls, permutation, period_s, guarded};
  const MfNeighbours neighbours = {start, x, y, z, vx, vy, vz};
  const MfEight e = mf_sorted_eight(&neighbours, id, eights[item], eights[item + 1] - eights[item]);
  const F3 v = mf_brownian_velocity(&e, &brownian, &setting);
  mf_scatter(out_x, e.id, v.x, e.lanes);
  mf_scatter(out_y, e.id, v.y, e.lanes);
  mf_scatter(out_z, e.id, v.z, e.lanes);
}
