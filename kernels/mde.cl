// One sweep of minimum distance enforcement: one agent a work item, in the order in which they are sorted by
// cell.
#include "kernels/mde.h"

// dx, dy, dz: the displacement of each sorted agent, 0 where nobody is too near.
__kernel void displacement(const MfCells cells, __global const int* start, __global const float* x,
                           __global const float* y, __global const float* z,
                           __global const float* half_distance, __global const int* id, __global float* dx,
                           __global float* dy, __global float* dz, const int count) {
  const int a = (int)get_global_id(0);
  if (a >= count) return;
  MfBody self;
  self.x = x[a];
  self.y = y[a];
  self.z = z[a];
  self.half_distance = half_distance[a];
  self.id = id[a];
  const F3 d = mf_displacement(self, &cells, start, x, y, z, half_distance, id);
  dx[a] = mf_sum(d.x);
  dy[a] = mf_sum(d.y);
  dz[a] = mf_sum(d.z);
}
