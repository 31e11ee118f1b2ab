// Steps simulated robots: one work item takes eight of them through a whole batch of steps, because a launch
// costs more than a step. There are stride / MF_LANES items, rounded up to whole groups.
#include "kernels/plants.h"

__kernel void step_ideal(__global float* block, const int stride, const MfPlant plant) {
  const int first = (int)get_global_id(0) * MF_LANES;
  if (first < stride) mf_run_plant(block, stride, first, plant, MF_PLANT_IDEAL);
}

__kernel void step_velocity_lag(__global float* block, const int stride, const MfPlant plant) {
  const int first = (int)get_global_id(0) * MF_LANES;
  if (first < stride) mf_run_plant(block, stride, first, plant, MF_PLANT_VELOCITY_LAG);
}

__kernel void step_double_integrator(__global float* block, const int stride, const MfPlant plant) {
  const int first = (int)get_global_id(0) * MF_LANES;
  if (first < stride) mf_run_plant(block, stride, first, plant, MF_PLANT_DOUBLE_INTEGRATOR);
}
