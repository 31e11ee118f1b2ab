#include "controller/engine/moment.hpp"

#include <Random123/philox.h>

#include <cmath>

namespace mayfly {
namespace {

constexpr std::uint32_t kTickStream = 0x71C4B000U;

}  // namespace

kernels::MfMoment moment_of(const kernels::MfNoise& noise, std::uint64_t tick, double time_s) noexcept {
  constexpr double kWords = 4294967296.0;  // 2³²
  kernels::MfMoment moment{};
  const auto words = r123::Philox2x32()(
      {{static_cast<std::uint32_t>(tick), static_cast<std::uint32_t>(tick >> 32U) ^ kTickStream}},
      {{noise.seed}});
  moment.key_a = words[0];
  moment.key_b = words[1];
  for (int o = 0; o < noise.octaves; ++o) {
    const double cells =
        static_cast<double>(noise.drift) * time_s * static_cast<double>(noise.inverse_scale[o]);
    const double whole = std::floor(cells);
    // Modulo 2³², for the lattice's hash wraps round there, too.
    const double wrapped = whole - kWords * std::floor(whole / kWords);
    moment.drift_cells[o] = static_cast<int>(static_cast<std::uint32_t>(wrapped));
    moment.drift_rest[o] = static_cast<float>(cells - whole);
  }
  return moment;
}

}  // namespace mayfly
