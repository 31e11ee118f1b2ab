// The field model for one swarm: eight agents a work item.
#include "kernels/field.h"

// Slots first … first + count − 1 of `order`, which names the swarm's agents, one after the other in space;
// it is readable eight elements past its end. rest_x, y, z are the swarm's own. Velocities are written in the
// agents' order, the places where they will be after period_s in the order of slots.
__kernel void field_velocity(__global const float* x, __global const float* y, __global const float* z,
                             __global const int* order, __global const float* rest_x,
                             __global const float* rest_y, __global const float* rest_z, __global float* vx,
                             __global float* vy, __global float* vz, __global float* ahead_x,
                             __global float* ahead_y, __global float* ahead_z, const int first,
                             const int count, const float period_s, const MfField field,
                             const MfMoment moment, __global const float* walls, __global const float* guide,
                             __global const int* permutation) {
  const int agent = (int)get_global_id(0) * MF_LANES;
  if (agent >= count) return;
  const int slot = first + agent;
  const int lanes = min(MF_LANES, count - agent);
  const MfTables tables = {walls, guide, rest_x, rest_y, rest_z, permutation};
  const I id = mf_swarm_agents(order + slot, lanes);
  const F3 r = mf3(mf_gather(x, id), mf_gather(y, id), mf_gather(z, id));
  const F3 v = mf_of_present(r, mf_field_velocity(r, id, id - first, &field, &moment, &tables));
  mf_scatter(vx, id, v.x, lanes);
  mf_scatter(vy, id, v.y, lanes);
  mf_scatter(vz, id, v.z, lanes);
  const F3 ahead = mf3_add(r, mf3_scale(v, mf_splat(period_s)));
  mf_store_first(ahead_x + slot, ahead.x, lanes);
  mf_store_first(ahead_y + slot, ahead.y, lanes);
  mf_store_first(ahead_z + slot, ahead.z, lanes);
}
