#include "fields/eikonal_strips.hpp"

#include <cstring>

namespace mayfly::fields::strips {
namespace {

using kernels::F;
using kernels::I;
using kernels::mf_any;
using kernels::mf_isplat;
using kernels::mf_load;
using kernels::mf_max;
using kernels::mf_min;
using kernels::mf_select;
using kernels::mf_splat;
using kernels::mf_sqrt;
using kernels::mf_store;

constexpr std::ptrdiff_t kVector = MF_LANES;

// Lane l gets lane l − 1; lane 0 gets `first`.
MF_FN F shift_up(F a, float first) {
  F b = __builtin_shufflevector(a, a, 7, 0, 1, 2, 3, 4, 5, 6);
  b[0] = first;
  return b;
}

// Lane l gets lane l + 1; lane 7 gets `last`.
MF_FN F shift_down(F a, float last) {
  F b = __builtin_shufflevector(a, a, 1, 2, 3, 4, 5, 6, 7, 0);
  b[7] = last;
  return b;
}

// The Godunov upwind value from the smaller neighbour along each axis: the u with Σ max(u − aᵢ, 0)² = f². How
// many of the three take part follows without a root: the i-th does if the value from the others lies above
// it.
MF_FN F upwind_value(F ax, F ay, F az, F f) {
  const F low_xy = mf_min(ax, ay);
  const F high_xy = mf_max(ax, ay);
  const F a = mf_min(low_xy, az);
  const F rest = mf_max(low_xy, az);
  const F b = mf_min(high_xy, rest);
  const F c = mf_max(high_xy, rest);
  const F p = b - a;
  const F q = c - a;
  const F r = c - b;
  const F ff = f * f;
  const F pp = p * p;
  const F qq = q * q;
  const I three = qq + r * r < ff;
  const F sum = mf_select(three, p + q, p);
  const F discriminant = mf_select(three, sum * sum - 3.0f * (pp + qq - ff), ff + ff - pp);
  const F scale = mf_select(three, mf_splat(1.0f / 3.0f), mf_splat(0.5f));
  const F root = mf_sqrt(mf_max(discriminant, mf_splat(0.0f)));
  return a + mf_select(p < f, scale * (sum + root), f);
}

// A neighbour that depends on a cell has a larger value, and is not one that never changes.
MF_FN I depends(F neighbour, F value) {
  return (neighbour > value) & (neighbour < mf_splat(0.5f * (kFar + kClosed)));
}

MF_FN Range lanes_range(int n, int nx) {
  return {std::max(n - (kRows - 1), 0), std::min(n + 1, nx)};
}

// The one that a sweep in direction kStep meets first where `low` lies at smaller coordinates than `high`.
template <int kStep>
MF_FN F behind(F low, F high) {
  return kStep > 0 ? low : high;
}

// One vector of a plane after its update, and what stands beside it.
struct Swept {
  F value;
  I lowered;
  F behind_x, behind_y, ahead_y;
};

// Adds to `outcome` which neighbours of vector n of plane i must be updated again.
template <int kStep>
MF_FN void tell_neighbours(const Swept& swept, int i, int n, const float* cost, const Brick& brick,
                           const Layout& layout, Outcome& outcome) {
  constexpr int kFirst = kStep > 0 ? 0 : kRows - 1;  // the lane that is swept first
  constexpr int kLast = kRows - 1 - kFirst;
  const F value = swept.value;
  const Range lanes = lanes_range(n, layout.nx);
  outcome.changed.add(lanes);
  I back_y = swept.lowered & depends(swept.behind_y, value);
  if (back_y[kFirst]) {
    const int x = n - kFirst;
    outcome.y_back.add({x, x + 1});
    back_y[kFirst] = 0;
  }
  if ((swept.lowered & depends(swept.ahead_y, value))[kLast]) {
    const int x = n - kLast;
    outcome.y_ahead.add({x, x + 1});
  }
  I back = back_y | (swept.lowered & depends(swept.behind_x, value));
  const I z_back = swept.lowered & depends(mf_load(cost + brick.plane[i] + n * kVector), value);
  if (i > 0) {
    back |= z_back;
  } else if (mf_any(z_back)) {
    outcome.z_back.add(lanes);
  }
  if (i + 1 == kPlanes &&
      mf_any(swept.lowered & depends(mf_load(cost + brick.plane[i + 2] + n * kVector), value))) {
    outcome.z_ahead.add(lanes);
  }
  if (mf_any(back)) {
    outcome.self.add({std::max(lanes.begin - 1, 0), std::min(lanes.end + 1, layout.nx)});
  }
}

}  // namespace

template <int kStep>
Outcome sweep_brick(float* cost, const float* step, const Brick& brick, const Layout& layout, Range range) {
  Outcome outcome;
  // Plane i handles vector n = at − i · kStep; the vectors of the columns in `range` are range.begin …
  // range.end + 6.
  int at = kStep > 0 ? range.begin : range.end - 1 + (kRows - 1);
  int stop = kStep > 0 ? range.end + kLag : range.begin - kPlanes;
  const int last_stop = kStep > 0 ? layout.nx + kLag : -kPlanes;
  // Of the strips beside this one: the row next to ours, relative to a vector of ours.
  const std::ptrdiff_t below = -brick.strip_stride + (kRows - 1) * kVector + (kRows - 1);
  const std::ptrdiff_t above = brick.strip_stride - (kRows - 1) * kVector;

  Swept swept[kPlanes];
  for (int i = 0; i < kPlanes; ++i) {
    swept[i].value = mf_load(cost + brick.plane[i + 1] + (at - i * kStep - kStep) * kVector);
  }
  for (; at != stop; at += kStep) {
    I lowered_any = mf_isplat(0);
    for (int i = 0; i < kPlanes; ++i) {
      const std::ptrdiff_t n = at - i * kStep;
      float* here = cost + brick.plane[i + 1] + n * kVector;
      const F old = mf_load(here);
      const F previous = swept[i].value;
      const F ahead = mf_load(here + kStep * kVector);
      const F x_low = behind<kStep>(previous, ahead);
      const F x_high = behind<kStep>(ahead, previous);
      const F y_low = shift_up(x_low, here[below]);
      const F y_high = shift_down(x_high, here[above]);
      const F z_behind = mf_load(cost + brick.plane[i] + n * kVector);
      const F z_ahead = mf_load(cost + brick.plane[i + 2] + n * kVector);
      const F f = mf_load(step + brick.plane[i + 1] + n * kVector);
      const F value =
          upwind_value(mf_min(x_low, x_high), mf_min(y_low, y_high), mf_min(z_behind, z_ahead), f);
      swept[i] = {mf_min(value, old), value < old, previous, behind<kStep>(y_low, y_high),
                  behind<kStep>(y_high, y_low)};
      lowered_any |= swept[i].lowered;
      mf_store(here, swept[i].value);
    }
    outcome.steps += kPlanes;
    if (!mf_any(lowered_any)) {
      continue;
    }
    // Neighbours ahead within the brick all come in the next step.
    if (at + kStep == stop && stop != last_stop) {
      stop += kStep;
    }
    for (int i = 0; i < kPlanes; ++i) {
      if (mf_any(swept[i].lowered)) {
        tell_neighbours<kStep>(swept[i], i, at - i * kStep, cost, brick, layout, outcome);
      }
    }
  }
  return outcome;
}

template Outcome sweep_brick<1>(float*, const float*, const Brick&, const Layout&, Range);
template Outcome sweep_brick<-1>(float*, const float*, const Brick&, const Layout&, Range);

}  // namespace mayfly::fields::strips
