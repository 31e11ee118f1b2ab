// Lane types: one number for each of eight agents, in the subset that OpenCL C 1.2 and C++20 share. Every
// equation of the model is written once on them (see docs/decisions/0001-two-engines-one-source.md). Here
// stands all that the two languages spell differently; a kernel header uses only these names, arithmetic
// operators and comparisons.
//
//   F, I, U     eight floats, ints, unsigned ints         a < b   a mask: I with -1 (true) or 0 in each lane
//   F3          three F: a vector for each of eight agents
//
// Only + − × ÷ √ and integer operations appear, contraction is off: both languages give the same bits.
#ifndef MAYFLY_KERNELS_LANE_H
#define MAYFLY_KERNELS_LANE_H

#define MF_LANES 8

#ifdef __OPENCL_VERSION__

#pragma OPENCL FP_CONTRACT OFF

#define MF_FN static inline
#define MF_GLOBAL __global
typedef float8 F;
typedef int8 I;
typedef uint8 U;

MF_FN F mf_splat(float a) {
  return (F)(a);
}
MF_FN I mf_isplat(int a) {
  return (I)(a);
}
MF_FN U mf_usplat(uint a) {
  return (U)(a);
}
MF_FN F mf_select(I mask, F a, F b) {
  return select(b, a, mask);
}
MF_FN I mf_iselect(I mask, I a, I b) {
  return select(b, a, mask);
}
MF_FN F mf_to_float(I a) {
  return convert_float8(a);
}
MF_FN I mf_truncate(F a) {
  return convert_int8(a);
}
MF_FN U mf_as_bits(F a) {
  return as_uint8(a);
}
MF_FN F mf_from_bits(U a) {
  return as_float8(a);
}
MF_FN U mf_to_unsigned(I a) {
  return as_uint8(a);
}
MF_FN I mf_to_signed(U a) {
  return as_int8(a);
}
MF_FN F mf_sqrt(F a) {
  return sqrt(a);
}
MF_FN int mf_any(I mask) {
  return any(mask);
}
MF_FN int mf_all(I mask) {
  return all(mask);
}
MF_FN F mf_load(const MF_GLOBAL float* p) {
  return vload8(0, p);
}
MF_FN I mf_iload(const MF_GLOBAL int* p) {
  return vload8(0, p);
}
MF_FN void mf_store(MF_GLOBAL float* p, F a) {
  vstore8(a, 0, p);
}
// Sum of the lanes, always in this order.
MF_FN float mf_sum(F a) {
  return ((a.s0 + a.s1) + (a.s2 + a.s3)) + ((a.s4 + a.s5) + (a.s6 + a.s7));
}
MF_FN F mf_gather(const MF_GLOBAL float* p, I i) {
  return (F)(p[i.s0], p[i.s1], p[i.s2], p[i.s3], p[i.s4], p[i.s5], p[i.s6], p[i.s7]);
}
MF_FN I mf_igather(const MF_GLOBAL int* p, I i) {
  return (I)(p[i.s0], p[i.s1], p[i.s2], p[i.s3], p[i.s4], p[i.s5], p[i.s6], p[i.s7]);
}
// Four neighbouring floats for each lane, from p + i on.
MF_FN void mf_gather4(const MF_GLOBAL float* p, I i, F out[4]) {
  const float4 a = vload4(0, p + i.s0), b = vload4(0, p + i.s1), c = vload4(0, p + i.s2);
  const float4 d = vload4(0, p + i.s3), e = vload4(0, p + i.s4), f = vload4(0, p + i.s5);
  const float4 g = vload4(0, p + i.s6), h = vload4(0, p + i.s7);
  out[0] = (F)(a.s0, b.s0, c.s0, d.s0, e.s0, f.s0, g.s0, h.s0);
  out[1] = (F)(a.s1, b.s1, c.s1, d.s1, e.s1, f.s1, g.s1, h.s1);
  out[2] = (F)(a.s2, b.s2, c.s2, d.s2, e.s2, f.s2, g.s2, h.s2);
  out[3] = (F)(a.s3, b.s3, c.s3, d.s3, e.s3, f.s3, g.s3, h.s3);
}
// The first n lanes only.
MF_FN void mf_scatter(MF_GLOBAL float* p, I i, F a, int n) {
  const int at[MF_LANES] = {i.s0, i.s1, i.s2, i.s3, i.s4, i.s5, i.s6, i.s7};
  const float v[MF_LANES] = {a.s0, a.s1, a.s2, a.s3, a.s4, a.s5, a.s6, a.s7};
  for (int k = 0; k < n; ++k) p[at[k]] = v[k];
}
MF_FN void mf_unpack(I a, int out[MF_LANES]) {
  vstore8(a, 0, out);
}
MF_FN void mf_iscatter(MF_GLOBAL int* p, I i, I a, int n) {
  const int at[MF_LANES] = {i.s0, i.s1, i.s2, i.s3, i.s4, i.s5, i.s6, i.s7};
  const int v[MF_LANES] = {a.s0, a.s1, a.s2, a.s3, a.s4, a.s5, a.s6, a.s7};
  for (int k = 0; k < n; ++k) p[at[k]] = v[k];
}
MF_FN float mf_lane(F a, int k) {
  const float v[MF_LANES] = {a.s0, a.s1, a.s2, a.s3, a.s4, a.s5, a.s6, a.s7};
  return v[k];
}
typedef long Long;  // 64 bits in both languages
// Sum of the lanes in units of 2^-32: whole numbers, so that it does not depend on any order.
MF_FN Long mf_sum_fixed(F a) {
  const long8 n = convert_long8(a * 4294967296.0f);
  return n.s0 + n.s1 + n.s2 + n.s3 + n.s4 + n.s5 + n.s6 + n.s7;
}
// Sets a byte that other work items may set as well.
MF_FN void mf_mark(MF_GLOBAL uchar* p) {
  *p = 1;
}
MF_FN I mf_lane_index(void) {
  return (I)(0, 1, 2, 3, 4, 5, 6, 7);
}
// The first n lanes only.
MF_FN void mf_store_first(MF_GLOBAL float* p, F a, int n) {
  const float v[MF_LANES] = {a.s0, a.s1, a.s2, a.s3, a.s4, a.s5, a.s6, a.s7};
  for (int k = 0; k < n; ++k) p[k] = v[k];
}

#define MF_BEGIN
#define MF_END

#else

#include <cstdint>
#include <cstring>

#define MF_FN [[gnu::always_inline]] inline
#define MF_GLOBAL
#define MF_BEGIN namespace mayfly::kernels {
#define MF_END }

MF_BEGIN

typedef unsigned char uchar;
typedef unsigned int uint;
typedef std::int64_t Long;
typedef float F __attribute__((vector_size(4 * MF_LANES)));
typedef int I __attribute__((vector_size(4 * MF_LANES)));
typedef uint U __attribute__((vector_size(4 * MF_LANES)));

MF_FN F mf_splat(float a) {
  return F{a, a, a, a, a, a, a, a};
}
MF_FN I mf_isplat(int a) {
  return I{a, a, a, a, a, a, a, a};
}
MF_FN U mf_usplat(uint a) {
  return U{a, a, a, a, a, a, a, a};
}
MF_FN F mf_select(I mask, F a, F b) {
  return mask ? a : b;
}
MF_FN I mf_iselect(I mask, I a, I b) {
  return mask ? a : b;
}
MF_FN F mf_to_float(I a) {
  return __builtin_convertvector(a, F);
}
MF_FN I mf_truncate(F a) {
  return __builtin_convertvector(a, I);
}
MF_FN U mf_as_bits(F a) {
  return reinterpret_cast<U>(a);
}
MF_FN F mf_from_bits(U a) {
  return reinterpret_cast<F>(a);
}
MF_FN U mf_to_unsigned(I a) {
  return reinterpret_cast<U>(a);
}
MF_FN I mf_to_signed(U a) {
  return reinterpret_cast<I>(a);
}
MF_FN F mf_sqrt(F a) {
  F root;
  for (int k = 0; k < MF_LANES; ++k) root[k] = __builtin_sqrtf(a[k]);
  return root;
}
MF_FN int mf_any(I mask) {
#ifdef __AVX__
  // Searches ask for each neighbour: one instruction instead of eight.
  typedef long long Quad __attribute__((vector_size(32)));
  const Quad bits = reinterpret_cast<Quad>(mask);
  return __builtin_ia32_ptestz256(bits, bits) == 0;
#else
  long long part[MF_LANES / 2];
  std::memcpy(part, &mask, sizeof part);
  return (part[0] | part[1] | part[2] | part[3]) != 0;
#endif
}
MF_FN int mf_all(I mask) {
  return !mf_any(~mask);
}
MF_FN F mf_load(const float* p) {
  F a;
  std::memcpy(&a, p, sizeof a);
  return a;
}
MF_FN I mf_iload(const int* p) {
  I a;
  std::memcpy(&a, p, sizeof a);
  return a;
}
MF_FN void mf_store(float* p, F a) {
  std::memcpy(p, &a, sizeof a);
}
// Sum of the lanes, always in this order.
MF_FN float mf_sum(F a) {
  return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7]));
}
MF_FN F mf_gather(const float* p, I i) {
  return F{p[i[0]], p[i[1]], p[i[2]], p[i[3]], p[i[4]], p[i[5]], p[i[6]], p[i[7]]};
}
MF_FN I mf_igather(const int* p, I i) {
  return I{p[i[0]], p[i[1]], p[i[2]], p[i[3]], p[i[4]], p[i[5]], p[i[6]], p[i[7]]};
}
MF_FN void mf_gather4(const float* p, I i, F out[4]) {
  typedef float Quad __attribute__((vector_size(16)));
  Quad q[MF_LANES];
  for (int k = 0; k < MF_LANES; ++k) std::memcpy(&q[k], p + i[k], sizeof(Quad));
  const F a = __builtin_shufflevector(q[0], q[4], 0, 1, 2, 3, 4, 5, 6, 7);
  const F b = __builtin_shufflevector(q[1], q[5], 0, 1, 2, 3, 4, 5, 6, 7);
  const F c = __builtin_shufflevector(q[2], q[6], 0, 1, 2, 3, 4, 5, 6, 7);
  const F d = __builtin_shufflevector(q[3], q[7], 0, 1, 2, 3, 4, 5, 6, 7);
  const F ab_low = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
  const F cd_low = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
  const F ab_high = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
  const F cd_high = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
  out[0] = __builtin_shufflevector(ab_low, cd_low, 0, 1, 8, 9, 4, 5, 12, 13);
  out[1] = __builtin_shufflevector(ab_low, cd_low, 2, 3, 10, 11, 6, 7, 14, 15);
  out[2] = __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13);
  out[3] = __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15);
}
MF_FN void mf_scatter(float* p, I i, F a, int n) {
  for (int k = 0; k < n; ++k) p[i[k]] = a[k];
}
MF_FN void mf_iscatter(int* p, I i, I a, int n) {
  for (int k = 0; k < n; ++k) p[i[k]] = a[k];
}
MF_FN float mf_lane(F a, int k) {
  return a[k];
}
MF_FN void mf_unpack(I a, int out[MF_LANES]) {
  std::memcpy(out, &a, sizeof a);
}
MF_FN Long mf_sum_fixed(F a) {
  Long sum = 0;
  for (int k = 0; k < MF_LANES; ++k) sum += static_cast<Long>(a[k] * 4294967296.0f);
  return sum;
}
MF_FN void mf_mark(uchar* p) {
  __atomic_store_n(p, uchar{1}, __ATOMIC_RELAXED);
}
MF_FN I mf_lane_index() {
  return I{0, 1, 2, 3, 4, 5, 6, 7};
}
MF_FN void mf_store_first(float* p, F a, int n) {
  std::memcpy(p, &a, sizeof(float) * static_cast<std::size_t>(n));
}

MF_END

#endif

// From here on both languages read the same text.
MF_BEGIN

typedef struct {
  F x, y, z;
} F3;

// a where the mask holds, else 0: one instruction, where a select may take three.
MF_FN F mf_kept(I mask, F a) {
  return mf_from_bits(mf_as_bits(a) & mf_to_unsigned(mask));
}

// NaN in a gives b: an unordered comparison is false.
MF_FN F mf_min(F a, F b) {
  return mf_select(a < b, a, b);
}
MF_FN F mf_max(F a, F b) {
  return mf_select(a > b, a, b);
}
MF_FN I mf_imin(I a, I b) {
  return mf_iselect(a < b, a, b);
}
MF_FN I mf_imax(I a, I b) {
  return mf_iselect(a > b, a, b);
}
// The least and the greatest of the lanes.
MF_FN float mf_least(F a) {
  float least = mf_lane(a, 0);
  for (int k = 1; k < MF_LANES; ++k) least = mf_lane(a, k) < least ? mf_lane(a, k) : least;
  return least;
}
MF_FN float mf_greatest(F a) {
  float greatest = mf_lane(a, 0);
  for (int k = 1; k < MF_LANES; ++k) greatest = mf_lane(a, k) > greatest ? mf_lane(a, k) : greatest;
  return greatest;
}
MF_FN F mf_clamp(F a, float low, float high) {
  return mf_min(mf_max(a, mf_splat(low)), mf_splat(high));
}

// The greatest whole number not above a, for |a| ≤ 2^30; beyond that, and of NaN, some whole number that far
// out, so that the sums made of it fit as well.
MF_FN I mf_floor(F a) {
  const I whole = mf_truncate(mf_clamp(a, -1073741824.0f, 1073741824.0f));
  return whole + (mf_to_float(whole) > a);  // a mask is -1 where it holds
}

MF_FN F3 mf3(F x, F y, F z) {
  F3 v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}
MF_FN F3 mf3_splat(float x, float y, float z) {
  return mf3(mf_splat(x), mf_splat(y), mf_splat(z));
}
MF_FN F3 mf3_add(F3 a, F3 b) {
  return mf3(a.x + b.x, a.y + b.y, a.z + b.z);
}
MF_FN F3 mf3_sub(F3 a, F3 b) {
  return mf3(a.x - b.x, a.y - b.y, a.z - b.z);
}
MF_FN F3 mf3_scale(F3 a, F s) {
  return mf3(a.x * s, a.y * s, a.z * s);
}
MF_FN F mf3_dot(F3 a, F3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
MF_FN F3 mf3_cross(F3 a, F3 b) {
  return mf3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
MF_FN F3 mf3_select(I mask, F3 a, F3 b) {
  return mf3(mf_select(mask, a.x, b.x), mf_select(mask, a.y, b.y), mf_select(mask, a.z, b.z));
}
MF_FN F3 mf3_kept(I mask, F3 a) {
  return mf3(mf_kept(mask, a.x), mf_kept(mask, a.y), mf_kept(mask, a.z));
}
MF_FN F mf3_length(F3 a) {
  return mf_sqrt(mf3_dot(a, a));
}
// u/|u|, and 0 where |u| < 1e-9: a zero-length vector never makes a NaN (model.md, conventions).
MF_FN F3 mf3_unit(F3 a) {
  const F length = mf3_length(a);
  const I tiny = length < mf_splat(1e-9f);
  const F inverse = mf_select(tiny, mf_splat(0.0f), 1.0f / mf_select(tiny, mf_splat(1.0f), length));
  return mf3_scale(a, inverse);
}

MF_END

#endif
