// Gradient noise with analytic derivatives, three noises at once, and its curl (Wang14 §4; Perlin 2002).
#ifndef MAYFLY_KERNELS_NOISE_H
#define MAYFLY_KERNELS_NOISE_H

#include "kernels/lane.h"

MF_BEGIN

#define MF_MAX_OCTAVES 4

#define MF_NOISE_CURL 0
#define MF_NOISE_PERLIN 1
#define MF_NOISE_WHITE 2
#define MF_NOISE_GAUSSIAN 3

// The vector potential P(x) = Σ gain · (p1, p2, p3)(x/scale), and what is made of it.
typedef struct {
  int kind;
  int octaves;
  int permuted;  // 1: lattice gradients by the published permutation table, 0: by an integer hash
  uint seed;
  float inverse_scale[MF_MAX_OCTAVES];  // 1/m
  float gain[MF_MAX_OCTAVES];           // m²/s, so that its curl is a velocity
  float rms_speed;                      // m/s, of MF_NOISE_WHITE and MF_NOISE_GAUSSIAN
  float drift;                          // m/s: each potential drifts along an axis of its own
} MfNoise;

// What changes from tick to tick: the key of its random draws, and how far the potentials have drifted, in
// whole lattice cells (modulo 2³²) and the rest in [0, 1), for each octave. The host makes it in double
// (controller/engine/moment.hpp), so that noise is as fine after a day as at the start.
typedef struct {
  uint key_a, key_b;
  int drift_cells[MF_MAX_OCTAVES];
  float drift_rest[MF_MAX_OCTAVES];
} MfMoment;

// A vector field at a point: its value and its Jacobian, row c the gradient of component c.
typedef struct {
  F3 value;
  F3 dx, dy, dz;  // ∂/∂x, ∂/∂y, ∂/∂z of the three components
} MfJet;

MF_FN F3 mf_curl(MfJet j) {
  return mf3(j.dy.z - j.dz.y, j.dz.x - j.dx.z, j.dx.y - j.dy.x);
}

// Odd multipliers of a lattice point's coordinates.
#define MF_HASH_X 0x8da6b343u
#define MF_HASH_Y 0xd8163841u
#define MF_HASH_Z 0xcb1ab31fu

// A well-mixed word for each lattice point; the three noises take four bits each from its top, so that one
// hash serves all. Mixing constants: C. Wellons, "lowbias32".
MF_FN U mf_mix(U h) {
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h;
}

// Perlin's twelve edge gradients in sixteen slots. Bit s of `present` says whether slot s has this component,
// bit s of `negative` its sign. `shift` is 31 − slot, so that the slot's bit lands on the sign bit.
MF_FN F mf_gradient_component(U shift, uint present, uint negative) {
  const U is_there = mf_to_unsigned(mf_to_signed(mf_usplat(present) << shift) >> 31);
  const U sign = (mf_usplat(negative) << shift) & 0x80000000u;
  return mf_from_bits((is_there & 0x3f800000u) | sign);
}
MF_FN F3 mf_gradient(U slot) {
  const U shift = 31u - slot;
  return mf3(mf_gradient_component(shift, 0x50ffu, 0x40aau), mf_gradient_component(shift, 0xff0fu, 0xaa0cu),
             mf_gradient_component(shift, 0xaff0u, 0x8cc0u));
}

typedef struct {
  F s, slope;
} MfFade;

// Quintic fade 6t⁵ − 15t⁴ + 10t³ and its derivative.
MF_FN MfFade mf_fade(F t) {
  MfFade f;
  f.s = t * t * t * (10.0f + t * (-15.0f + t * 6.0f));
  f.slope = 30.0f * t * t * (1.0f + t * (-2.0f + t));
  return f;
}

// Adds one corner of the lattice cell. w: the corner's weight, and its derivatives along x, y, z; d: from
// corner to point.
MF_FN void mf_add_corner(F* p, F* px, F* py, F* pz, U slot, F3 d, F w, F3 dw) {
  const F3 g = mf_gradient(slot);
  const F rise = mf3_dot(g, d);
  *p += w * rise;
  *px += w * g.x + dw.x * rise;
  *py += w * g.y + dw.y * rise;
  *pz += w * g.z + dw.z * rise;
}

// The three noises at lattice coordinates q (no unit), value and derivatives. `table` is Perlin's
// permutation, 512 entries, read only where `permuted`.
MF_FN MfJet mf_noise3(F3 q, uint seed, int permuted, const MF_GLOBAL int* table) {
  const I ix = mf_floor(q.x);
  const I iy = mf_floor(q.y);
  const I iz = mf_floor(q.z);
  const F3 t = mf3(q.x - mf_to_float(ix), q.y - mf_to_float(iy), q.z - mf_to_float(iz));
  const MfFade fx = mf_fade(t.x);
  const MfFade fy = mf_fade(t.y);
  const MfFade fz = mf_fade(t.z);
  const F zero = mf_splat(0.0f);
  MfJet j;
  j.value = mf3(zero, zero, zero);
  j.dx = j.value;
  j.dy = j.value;
  j.dz = j.value;
  const U hx = mf_to_unsigned(ix) * MF_HASH_X + seed;
  const U hy = mf_to_unsigned(iy) * MF_HASH_Y;
  const U hz = mf_to_unsigned(iz) * MF_HASH_Z;
#ifndef __OPENCL_VERSION__
#pragma GCC unroll 8
#endif
  for (int corner = 0; corner < 8; ++corner) {
    const int cx = corner & 1;
    const int cy = (corner >> 1) & 1;
    const int cz = corner >> 2;
    const F3 d = mf3(t.x - (float)cx, t.y - (float)cy, t.z - (float)cz);
    const F wx = cx ? fx.s : 1.0f - fx.s;
    const F wy = cy ? fy.s : 1.0f - fy.s;
    const F wz = cz ? fz.s : 1.0f - fz.s;
    const F sx = cx ? fx.slope : -fx.slope;
    const F sy = cy ? fy.slope : -fy.slope;
    const F sz = cz ? fz.slope : -fz.slope;
    const F w = wx * wy * wz;
    const F3 dw = mf3(sx * wy * wz, wx * sy * wz, wx * wy * sz);
    U s1, s2, s3;
    if (permuted) {
      // One permutation, three noises: the second and third, and other seeds than 0, read it at a shifted
      // place.
      const I x = (ix + (cx + (int)(seed & 255u))) & 255;
      const I y = (iy + (cy + (int)((seed >> 8) & 255u))) & 255;
      const I z = (iz + (cz + (int)((seed >> 16) & 255u))) & 255;
      s1 = mf_to_unsigned(mf_igather(table, mf_igather(table, mf_igather(table, x) + y) + z)) & 15u;
      const I x2 = (x + 85) & 255;
      s2 = mf_to_unsigned(mf_igather(table, mf_igather(table, mf_igather(table, x2) + y) + z)) & 15u;
      const I x3 = (x + 170) & 255;
      s3 = mf_to_unsigned(mf_igather(table, mf_igather(table, mf_igather(table, x3) + y) + z)) & 15u;
    } else {
      const U h =
          mf_mix((cx ? hx + MF_HASH_X : hx) + (cy ? hy + MF_HASH_Y : hy) + (cz ? hz + MF_HASH_Z : hz));
      s1 = h >> 28;
      s2 = (h >> 24) & 15u;
      s3 = (h >> 20) & 15u;
    }
    mf_add_corner(&j.value.x, &j.dx.x, &j.dy.x, &j.dz.x, s1, d, w, dw);
    mf_add_corner(&j.value.y, &j.dx.y, &j.dy.y, &j.dz.y, s2, d, w, dw);
    mf_add_corner(&j.value.z, &j.dx.z, &j.dy.z, &j.dz.z, s3, d, w, dw);
  }
  return j;
}

// The seed with which the noise reads at lattice point p what it else reads at p + cells · e_axis: drifting
// by whole cells costs nothing.
MF_FN uint mf_drifted_seed(uint seed, int permuted, int axis, int cells) {
  if (permuted) {
    const int shift = 8 * axis;
    const uint part = (seed >> shift) + (uint)cells;
    return (seed & ~(255u << shift)) | ((part & 255u) << shift);
  }
  return seed + (uint)cells * (axis == 0 ? MF_HASH_X : axis == 1 ? MF_HASH_Y : MF_HASH_Z);
}

// mf_noise3 with its first noise drifted along x, the second along y, the third along z: their curl changes
// its shape, and stays a curl.
MF_FN MfJet mf_drifting_noise3(F3 q, uint seed, int permuted, int cells, float rest,
                               const MF_GLOBAL int* table) {
  const MfJet a =
      mf_noise3(mf3(q.x + rest, q.y, q.z), mf_drifted_seed(seed, permuted, 0, cells), permuted, table);
  const MfJet b =
      mf_noise3(mf3(q.x, q.y + rest, q.z), mf_drifted_seed(seed, permuted, 1, cells), permuted, table);
  const MfJet c =
      mf_noise3(mf3(q.x, q.y, q.z + rest), mf_drifted_seed(seed, permuted, 2, cells), permuted, table);
  MfJet j;
  j.value = mf3(a.value.x, b.value.y, c.value.z);
  j.dx = mf3(a.dx.x, b.dx.y, c.dx.z);
  j.dy = mf3(a.dy.x, b.dy.y, c.dy.z);
  j.dz = mf3(a.dz.x, b.dz.y, c.dz.z);
  return j;
}

// The potential P and its Jacobian at x (m); `drifting` is a literal at each call, and `moment` only read
// where it is set.
MF_FN MfJet mf_potential_sum(F3 x, const MfNoise* noise, const MfMoment* moment, int drifting,
                             const MF_GLOBAL int* table) {
  MfJet sum;
  sum.value = mf3_splat(0.0f, 0.0f, 0.0f);
  sum.dx = sum.value;
  sum.dy = sum.value;
  sum.dz = sum.value;
  for (int o = 0; o < noise->octaves; ++o) {
    const F3 q = mf3_scale(x, mf_splat(noise->inverse_scale[o]));
    const uint seed = noise->seed + (uint)o * 0x9e3779b9u;
    const MfJet j = drifting ? mf_drifting_noise3(q, seed, noise->permuted, moment->drift_cells[o],
                                                  moment->drift_rest[o], table)
                             : mf_noise3(q, seed, noise->permuted, table);
    const F gain = mf_splat(noise->gain[o]);
    const F slope = mf_splat(noise->gain[o] * noise->inverse_scale[o]);
    sum.value = mf3_add(sum.value, mf3_scale(j.value, gain));
    sum.dx = mf3_add(sum.dx, mf3_scale(j.dx, slope));
    sum.dy = mf3_add(sum.dy, mf3_scale(j.dy, slope));
    sum.dz = mf3_add(sum.dz, mf3_scale(j.dz, slope));
  }
  return sum;
}

// Of noise that stands still, whatever noise->drift.
MF_FN MfJet mf_potential(F3 x, const MfNoise* noise, const MF_GLOBAL int* table) {
  return mf_potential_sum(x, noise, (const MfMoment*)0, 0, table);
}
// At one tick.
MF_FN MfJet mf_potential_at(F3 x, const MfNoise* noise, const MfMoment* moment, const MF_GLOBAL int* table) {
  return noise->drift != 0.0f ? mf_potential_sum(x, noise, moment, 1, table) : mf_potential(x, noise, table);
}

// V = ∇ × P(x), m/s (Wang14 Eq. 1). What only the value and the diagonal derivatives need is dead code here,
// and removed.
MF_FN F3 mf_curl_noise(F3 x, const MfNoise* noise, const MF_GLOBAL int* table) {
  return mf_curl(mf_potential(x, noise, table));
}
MF_FN F3 mf_curl_noise_at(F3 x, const MfNoise* noise, const MfMoment* moment, const MF_GLOBAL int* table) {
  return noise->drift != 0.0f ? mf_curl(mf_potential_sum(x, noise, moment, 1, table))
                              : mf_curl_noise(x, noise, table);
}

MF_END

#endif
