// Picks the lanes of a mask out of a vector: what a search writes down. Host code only, for OpenCL C 1.2 has
// no fast way to do it.
#pragma once

#include <array>
#include <bit>
#include <cstring>

#include "kernels/lane.h"

namespace mayfly {

// Bit k is set where lane k holds.
inline unsigned mask_bits(kernels::I mask) {
#ifdef __AVX__
  return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<kernels::F>(mask)));
#else
  unsigned bits = 0;
  for (int k = 0; k < MF_LANES; ++k) {
    bits |= (mask[k] != 0 ? 1U : 0U) << static_cast<unsigned>(k);
  }
  return bits;
#endif
}

namespace detail {

// For each mask, which lanes it holds, in order.
constexpr std::array<std::array<int, MF_LANES>, 256> picked_lanes() {
  std::array<std::array<int, MF_LANES>, 256> table{};
  for (unsigned bits = 0; bits < 256; ++bits) {
    std::size_t n = 0;
    for (unsigned lane = 0; lane < MF_LANES; ++lane) {
      if ((bits >> lane & 1U) != 0) {
        table[bits][n++] = static_cast<int>(lane);
      }
    }
  }
  return table;
}
alignas(32) inline constexpr auto kPickedLanes = picked_lanes();

}  // namespace detail

// Writes those lanes of `a` that `bits` names to p, in order; all eight places there are overwritten.
inline void store_picked(int* p, kernels::I a, unsigned bits) {
  const auto& lanes = detail::kPickedLanes[bits];
#ifdef __AVX2__
  const kernels::I picked = __builtin_ia32_permvarsi256(a, kernels::mf_iload(lanes.data()));
  std::memcpy(p, &picked, sizeof picked);
#else
  for (std::size_t k = 0; k < MF_LANES; ++k) {
    p[k] = a[lanes[k]];
  }
#endif
}
inline void store_picked(float* p, kernels::F a, unsigned bits) {
  static_assert(sizeof(float) == sizeof(int));
  int words[MF_LANES];
  store_picked(words, reinterpret_cast<kernels::I>(a), bits);
  std::memcpy(p, words, sizeof words);
}

}  // namespace mayfly
