// Collision avoidance for one swarm: eight agents a work item.
#include "kernels/orca.h"

// Slots first … first + count − 1 of `slots`, which names the swarm's agents by their sorted numbers; it is
// readable eight elements past its end. vx, vy, vz (m/s, in the agents' order) are what the agents prefer,
// and become what keeps them clear of others. infeasible: 1 for each slot whose agent nothing keeps clear,
// else 0.
__kernel void avoid(__global const float* body, __global const float* motion, __global const int* id,
                    __global const int* nearest, const int stride, __global const int* slots, const int first,
                    const int count, __global float* vx, __global float* vy, __global float* vz,
                    __global float* infeasible, const float period_s, const MfAvoidance avoidance,
                    const MfField field, __global const float* walls) {
  const int agent = (int)get_global_id(0) * MF_LANES;
  if (agent >= count) return;
  const int lanes = min(MF_LANES, count - agent);
  const MfMinded all = {body, motion, id, nearest, stride};
  const I slot = mf_swarm_agents(slots + first + agent, lanes);
  const I number = mf_igather(id, slot);
  const F3 wish = mf3(mf_gather(vx, number), mf_gather(vy, number), mf_gather(vz, number));
  const MfAvoided out = mf_avoid(slot, wish, &all, &avoidance, &field, walls, period_s);
  mf_scatter(vx, number, out.v.x, lanes);
  mf_scatter(vy, number, out.v.y, lanes);
  mf_scatter(vz, number, out.v.z, lanes);
  const F count_one = mf_select(out.infeasible, mf_splat(1.0f), mf_splat(0.0f));
  mf_store_first(infeasible + first + agent, count_one, lanes);
}
