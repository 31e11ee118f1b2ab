// The noises that curl noise is compared with (Wang14 §7.1, Ren16): as fast in the rms, not free of
// divergence.
#ifndef MAYFLY_KERNELS_RANDOM_NOISE_H
#define MAYFLY_KERNELS_RANDOM_NOISE_H

#include "kernels/draw.h"

MF_BEGIN

// Perlin noise P itself as a velocity, m/s: Σ k · gain/scale · (p1, p2, p3)(x/scale). k = 1.718 / (√3 ·
// 0.269) is the rms of |∇ × P| over that of |P| (model.md §1), so that both fly equally fast.
#define MF_PERLIN_SPEED 3.6873f
MF_FN F3 mf_perlin_noise(F3 x, const MfNoise* noise, const MfMoment* moment, const MF_GLOBAL int* table) {
  MfNoise as_speed = *noise;
  for (int o = 0; o < MF_MAX_OCTAVES; ++o) as_speed.gain[o] *= MF_PERLIN_SPEED * noise->inverse_scale[o];
  return mf_potential_at(x, &as_speed, moment, table).value;
}

// White noise W, m/s: each component uniform in ±rms_speed, whose variance is a third of its square, so that
// the three together have this rms. New each tick.
MF_FN F3 mf_white_noise(I id, const MfNoise* noise, const MfMoment* moment) {
  const F3 w = mf3(mf_symmetric_interval(mf_draw(moment, id, MF_STREAM_NOISE)),
                   mf_symmetric_interval(mf_draw(moment, id, MF_STREAM_NOISE + 1u)),
                   mf_symmetric_interval(mf_draw(moment, id, MF_STREAM_NOISE + 2u)));
  return mf3_scale(w, mf_splat(noise->rms_speed));
}

// Gaussian noise G = λ √(−2 ln W1) sin 2πW2 in each component, m/s, λ = rms_speed/√3 (model.md §1). New each
// tick.
MF_FN F3 mf_gaussian_noise(I id, const MfNoise* noise, const MfMoment* moment) {
  const F3 g = mf3(
      mf_normal_draw(mf_draw(moment, id, MF_STREAM_NOISE), mf_draw(moment, id, MF_STREAM_NOISE + 1u)),
      mf_normal_draw(mf_draw(moment, id, MF_STREAM_NOISE + 2u), mf_draw(moment, id, MF_STREAM_NOISE + 3u)),
      mf_normal_draw(mf_draw(moment, id, MF_STREAM_NOISE + 4u), mf_draw(moment, id, MF_STREAM_NOISE + 5u)));
  return mf3_scale(g, mf_splat(noise->rms_speed * 0.57735027f));
}

// Whichever of them the swarm has.
MF_FN F3 mf_other_noise(F3 x, I id, const MfNoise* noise, const MfMoment* moment,
                        const MF_GLOBAL int* table) {
  if (noise->kind == MF_NOISE_PERLIN) return mf_perlin_noise(x, noise, moment, table);
  if (noise->kind == MF_NOISE_WHITE) return mf_white_noise(id, noise, moment);
  return mf_gaussian_noise(id, noise, moment);
}

MF_END

#endif
