// Random numbers without a state: what is drawn depends on what for, not on when or by whom.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace mayfly::sim_hal {

// Which of a sample's draws; each its own independent stream.
enum class Draw : std::uint32_t { kNoise = 1, kLoss = 2, kFreeze = 3, kPoll = 4, kSend = 5 };

// Four independent uniform 32-bit numbers (Philox4x32-10, Salmon et al. 2011).
inline std::array<std::uint32_t, 4> draw(std::uint64_t seed, std::uint32_t robot, std::int64_t tick,
                                         Draw what) {
  const auto t = static_cast<std::uint64_t>(tick);
  const r123::Philox4x32::ctr_type counter{{robot, static_cast<std::uint32_t>(t),
                                            static_cast<std::uint32_t>(t >> 32U),
                                            static_cast<std::uint32_t>(what)}};
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)}};
  const auto r = r123::Philox4x32{}(counter, key);
  return {r[0], r[1], r[2], r[3]};
}

// In [0, 1).
inline double unit(std::uint32_t bits) {
  return static_cast<double>(bits) * 0x1p-32;
}

// Two independent standard normal numbers (Box and Muller 1958).
inline std::array<double, 2> normal(std::uint32_t a, std::uint32_t b) {
  const double radius = std::sqrt(-2.0 * std::log(unit(a) + 0x1p-33));  // never the logarithm of 0
  const double angle = 2.0 * std::numbers::pi * unit(b);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace mayfly::sim_hal
