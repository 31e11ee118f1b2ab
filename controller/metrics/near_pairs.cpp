#include "controller/metrics/near_pairs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mayfly {
namespace {

constexpr std::size_t kTouchesPerAgent = 8;
constexpr std::size_t kBitsPerSlot = 8;
// Cells are a little larger than twice the reach, so that rounding cannot make an agent meet three in a row.
constexpr double kCellPerReach = 2.001;
constexpr double kFarthestCell = 1LL << 40U;  // beyond it, rounding would be a noticeable part of a cell

}  // namespace

NearPairs::NearPairs(std::span<const float> radii) : radii_(radii.begin(), radii.end()) {
  float largest = 0.0F;
  for (const float radius : radii_) {
    largest = radius > largest ? radius : largest;
  }
  widest_ = 2.0 * static_cast<double>(largest);
  const std::size_t agents = radii_.size();
  slots_.assign(std::bit_ceil(2 * agents + 1), 0);
  occupied_.assign(slots_.size() * kBitsPerSlot / 64 + 1, 0);
  hash_mask_ = slots_.size() * kBitsPerSlot - 1;
  bodies_.reserve(agents);
  touching_.reserve(kTouchesPerAgent * agents);
  before_.reserve(kTouchesPerAgent * agents);
}

double NearPairs::min_distance() const noexcept {
  return std::sqrt(least_squared_);
}

void NearPairs::observe(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                        std::span<const std::uint8_t> present) noexcept {
  std::swap(touching_, before_);
  touching_.clear();
  overflowed_ = false;
  collect(x, y, z, present);
  if (bodies_.size() >= 2 && std::isinf(least_squared_)) {
    compare(bodies_[0], bodies_[1]);  // any pair's distance is a reach to begin with
    touching_.clear();                // it will be met again
  }
  empty_cells();
  for (std::uint32_t i = 0; i < bodies_.size() && !overflowed_; ++i) {
    if (compare_with_cells(i)) {
      insert(i);
      continue;
    }
    empty_cells();
    for (std::uint32_t j = 0; j <= i; ++j) {
      insert(j);
    }
  }
  overflows_ += overflowed_ ? 1U : 0U;
  count_encounters();
}

void NearPairs::collect(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                        std::span<const std::uint8_t> present) noexcept {
  bodies_.clear();
  const std::size_t agents = std::min({radii_.size(), x.size(), y.size(), z.size()});
  for (std::size_t i = 0; i < agents; ++i) {
    const bool is_there = i >= present.size() || present[i] != 0;
    if (is_there && std::isfinite(x[i]) && std::isfinite(y[i]) && std::isfinite(z[i])) {
      bodies_.push_back({x[i], y[i], z[i], static_cast<std::uint32_t>(i), 0});
    }
  }
}

void NearPairs::empty_cells() noexcept {
  std::fill(slots_.begin(), slots_.end(), 0U);
  std::fill(occupied_.begin(), occupied_.end(), std::uint64_t{0});
  reach_ = std::max(std::sqrt(least_squared_), widest_);
  cells_per_m_ = 1.0 / (kCellPerReach * reach_);
}

std::int64_t NearPairs::cell_of(double coordinate) const noexcept {
  // Monotone, the clamp included, so that a neighbour's cell is always between those of the two ends of the
  // reach. A reach of 0 (all that matters is known) makes infinities, and a coordinate of 0 makes a NaN of
  // them: any cell will do.
  const double cell = std::floor(coordinate * cells_per_m_);
  if (!(cell < kFarthestCell)) {
    return static_cast<std::int64_t>(kFarthestCell);
  }
  return cell > -kFarthestCell ? static_cast<std::int64_t>(cell) : -static_cast<std::int64_t>(kFarthestCell);
}

std::size_t NearPairs::hash_of(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept {
  const std::uint64_t mixed = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15U +
                              static_cast<std::uint64_t>(j) * 0xC2B2AE3D27D4EB4FU +
                              static_cast<std::uint64_t>(k) * 0x165667B19E3779F9U;
  return static_cast<std::size_t>((mixed ^ (mixed >> 32U)) * 0x9E3779B97F4A7C15U >> 32U) & hash_mask_;
}

void NearPairs::insert(std::uint32_t body) noexcept {
  Body& b = bodies_[body];
  const std::size_t hash = hash_of(cell_of(b.x), cell_of(b.y), cell_of(b.z));
  occupied_[hash / 64] |= std::uint64_t{1} << (hash % 64);
  std::uint32_t& first = slots_[hash / kBitsPerSlot];
  b.next = first;
  first = body + 1;
}

// False once the minimum has halved since the cells were made.
bool NearPairs::compare_with_cells(std::uint32_t body) noexcept {
  const Body& b = bodies_[body];
  const Cells cells{{cell_of(b.x - reach_), cell_of(b.y - reach_), cell_of(b.z - reach_)},
                    {cell_of(b.x + reach_), cell_of(b.y + reach_), cell_of(b.z + reach_)}};
  std::size_t seen[8];
  std::size_t count = 0;
  for (std::int64_t i = cells.low[0]; i <= cells.high[0]; ++i) {
    for (std::int64_t j = cells.low[1]; j <= cells.high[1]; ++j) {
      for (std::int64_t k = cells.low[2]; k <= cells.high[2]; ++k) {
        const std::size_t hash = hash_of(i, j, k);
        if ((occupied_[hash / 64] >> (hash % 64) & 1U) == 0) {
          continue;
        }
        const std::size_t slot = hash / kBitsPerSlot;
        // Two cells may share a slot; its bodies must not be met twice.
        if (std::find(seen, seen + count, slot) != seen + count) {
          continue;
        }
        seen[count++] = slot;
        for (std::uint32_t other = slots_[slot]; other != 0; other = bodies_[other - 1].next) {
          compare(bodies_[other - 1], b);
        }
      }
    }
  }
  const double needed = std::max(least_squared_, widest_ * widest_);
  return 4.0 * needed >= reach_ * reach_;
}

void NearPairs::compare(const Body& a, const Body& b) noexcept {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  const double dz = a.z - b.z;
  const double squared = dx * dx + dy * dy + dz * dz;
  least_squared_ = squared < least_squared_ ? squared : least_squared_;
  const double sum = static_cast<double>(radii_[a.agent]) + radii_[b.agent];
  if (squared < sum * sum) {
    if (touching_.size() == touching_.capacity()) {
      overflowed_ = true;
      return;
    }
    touching_.emplace_back(std::min(a.agent, b.agent), std::max(a.agent, b.agent));
  }
}

void NearPairs::count_encounters() noexcept {
  std::sort(touching_.begin(), touching_.end());
  auto old = before_.begin();
  for (const Pair& pair : touching_) {
    old = std::lower_bound(old, before_.end(), pair);
    encounters_ += old == before_.end() || *old != pair ? 1U : 0U;
  }
}

}  // namespace mayfly
