// Random numbers on lanes: each is a function of (swarm, tick, agent, stream) and of nothing else, so that a
// run repeats itself on any number of threads and on either engine.
#ifndef MAYFLY_KERNELS_DRAW_H
#define MAYFLY_KERNELS_DRAW_H

#include "kernels/noise.h"

MF_BEGIN

// What a draw is for: pull k of a swarm has stream MF_STREAM_PULL + k, a component of the noise its own one
// or two.
#define MF_STREAM_NOISE 0u
#define MF_STREAM_PULL 16u
#define MF_STREAM_ENCOUNTER 32u
#define MF_STREAM_BROWNIAN 40u

// A word for each agent. Two mixings, each with a key of its own: agents, ticks and streams that are
// neighbours have nothing in common.
MF_FN U mf_draw(const MfMoment* moment, I id, uint stream) {
  const U h = mf_mix(mf_to_unsigned(id) * 0x9e3779b9u + moment->key_a);
  return mf_mix((h ^ (h >> 16)) + (moment->key_b + stream * 0x85ebca6bu));
}

// Uniform on the multiples of 2⁻²⁴ in [0, 1), made of a word's top bits.
MF_FN F mf_unit_interval(U word) {
  return mf_to_float(mf_to_signed(word >> 8)) * (1.0f / 16777216.0f);
}

// Uniform on the odd multiples of 2⁻²⁴ in (−1, 1): the mean is exactly zero.
MF_FN F mf_symmetric_interval(U word) {
  return mf_to_float(mf_to_signed(word >> 8) * 2 - 16777215) * (1.0f / 16777216.0f);
}

// ln a for normal a > 0, to a few units in the last place: a = 2ᵉ m with m in [√½, √2), and the series of
// ln m = 2 artanh((m − 1)/(m + 1)).
MF_FN F mf_log(F a) {
  const U bits = mf_as_bits(a);
  // 0x3f3504f3 is √½: what lies below it belongs to the exponent before.
  const U above = bits - 0x3f3504f3u;
  const F exponent = mf_to_float(mf_to_signed(above) >> 23);
  const F m = mf_from_bits((above & 0x007fffffu) + 0x3f3504f3u);
  const F s = (m - 1.0f) / (m + 1.0f);
  const F s2 = s * s;
  const F series = s2 * (1.0f / 3.0f + s2 * (1.0f / 5.0f + s2 * (1.0f / 7.0f + s2 * (1.0f / 9.0f))));
  return exponent * 0.69314718f + 2.0f * (s + s * series);
}

// sin 2πa for a in [0, 1]: whole quarters are taken off exactly, and a Taylor series on ±π/4 is left.
MF_FN F mf_sin_turns(F a) {
  const I quarter = mf_floor(a * 4.0f + 0.5f);
  const F x = (a * 4.0f - mf_to_float(quarter)) * 1.57079633f;
  const F x2 = x * x;
  const F sine =
      x + x * x2 * (-1.0f / 6.0f + x2 * (1.0f / 120.0f + x2 * (-1.0f / 5040.0f + x2 * (1.0f / 362880.0f))));
  const F cosine = 1.0f + x2 * (-0.5f + x2 * (1.0f / 24.0f + x2 * (-1.0f / 720.0f + x2 * (1.0f / 40320.0f))));
  const F value = mf_select((quarter & 1) != 0, cosine, sine);
  return mf_select((quarter & 2) != 0, -value, value);
}

// Standard normal (Box and Muller 1958): √(−2 ln W1) sin 2πW2 with W1 in (0, 1].
MF_FN F mf_normal_draw(U first, U second) {
  const F w1 = mf_to_float(mf_to_signed(first >> 8) + 1) * (1.0f / 16777216.0f);
  return mf_sqrt(-2.0f * mf_log(w1)) * mf_sin_turns(mf_unit_interval(second));
}

MF_END

#endif
