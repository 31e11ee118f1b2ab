// The first sweep of minimum distance enforcement: eight agents a work item, in the order in which they are
// sorted by cell.
#include "kernels/mde.h"

// pushed: 1 for each sorted agent that somebody is too near to, else 0; dx, dy, dz: its displacement (m),
// written only where `pushed` is 1. All columns are readable eight elements past `count`.
__kernel void displacement(const MfCells cells, __global const int* start, __global const float* x,
                           __global const float* y, __global const float* z,
                           __global const float* half_distance, __global const int* id, const float farthest,
                           const float slack, __global float* dx, __global float* dy, __global float* dz,
                           __global uchar* pushed, const int count) {
  const int first = (int)get_global_id(0) * MF_LANES;
  if (first >= count) return;
  const MfSorted sorted = {start, x, y, z, half_distance, id};
  const F3 r = mf3(mf_load(x + first), mf_load(y + first), mf_load(z + first));
  const MfReach box = mf_reach(r, mf_load(half_distance + first), farthest, slack, &cells);
  for (int lane = 0; lane < min(MF_LANES, count - first); ++lane) {
    const int a = first + lane;
    const MfPushed sum = mf_pushed(a, lane, &box, &cells, &sorted, 0);
    pushed[a] = (uchar)sum.neighbours;
    if (sum.neighbours) {
      dx[a] = mf_metres(sum.x);
      dy[a] = mf_metres(sum.y);
      dz[a] = mf_metres(sum.z);
    }
  }
}
