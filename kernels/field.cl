// The field model for one swarm: eight agents a work item.
#include "kernels/field.h"

// Agents first … first + count − 1 of the columns; rest_x, y, z are the swarm's own. Columns are readable
// eight elements past their end.
__kernel void field_velocity(__global const float* x, __global const float* y, __global const float* z,
                             __global const float* rest_x, __global const float* rest_y,
                             __global const float* rest_z, __global float* vx, __global float* vy,
                             __global float* vz, const int first, const int count, const MfField field,
                             const MfMoment moment,
                             __global const float* walls, __global const float* guide,
                             __global const int* table) {
  const int local_first = (int)get_global_id(0) * MF_LANES;
  if (local_first >= count) return;
  const int a = first + local_first;
  const int lanes = min(MF_LANES, count - local_first);
  const F3 r = mf3(mf_load(x + a), mf_load(y + a), mf_load(z + a));
  const F3 rest =
      mf3(mf_load(rest_x + local_first), mf_load(rest_y + local_first), mf_load(rest_z + local_first));
  const I id = mf_lane_index() + a;
  const F3 v = mf_field_velocity(r, rest, id, &field, &moment, walls, guide, table);
  if (lanes == MF_LANES) {
    mf_store(vx + a, v.x);
    mf_store(vy + a, v.y);
    mf_store(vz + a, v.z);
  } else {
    mf_store_first(vx + a, v.x, lanes);
    mf_store_first(vy + a, v.y, lanes);
    mf_store_first(vz + a, v.z, lanes);
  }
}
