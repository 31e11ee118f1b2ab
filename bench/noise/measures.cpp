#include "bench/noise/measures.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <optional>

#include "bench/noise/neighbours.hpp"
#include "bench/noise/spectrum.hpp"

namespace mayfly::bench {
namespace {

constexpr float kNear = 1.0F;    // m
constexpr float kAround = 4.0F;  // m
constexpr float kMiddle = 2.0F;  // m
constexpr std::size_t kTicksASample = 50;
constexpr std::size_t kWindow = 512;  // ticks, of a spectrum

std::size_t ticks_in(double seconds) {
  return static_cast<std::size_t>(std::lround(seconds / kPeriod));
}

double ratio(double a, double b) {
  return b > 0.0 ? a / b : 0.0;
}

// Of one moment.
struct Density {
  double clumping = 1.0;  // by chance, where nobody has neighbours
  double variation = 0.0;
  double near_share = 0.0;
};

Density density_of(std::span<const glm::vec3> at) {
  const Neighbours neighbours(at, kAround);
  double near = 0.0, around = 0.0, sum = 0.0, square = 0.0, too_near = 0.0;
  for (std::size_t a = 0; a < at.size(); ++a) {
    int middle = 0;
    bool touched = false;
    neighbours.for_each(at[a], kAround, [&](std::size_t other, float distance2) {
      if (other == a) {
        return;
      }
      around += 1.0;
      near += distance2 < kNear * kNear ? 1.0 : 0.0;
      middle += distance2 < kMiddle * kMiddle ? 1 : 0;
      touched = touched || static_cast<double>(distance2) < kSeparation * kSeparation;
    });
    sum += middle;
    square += static_cast<double>(middle) * middle;
    too_near += touched ? 1.0 : 0.0;
  }
  const auto n = static_cast<double>(at.size());
  const double mean = ratio(sum, n);
  Density density;
  density.clumping = around > 0.0 ? near / around * std::pow(kAround / kNear, 3) : 1.0;
  density.variation = ratio(std::sqrt(std::max(ratio(square, n) - mean * mean, 0.0)), mean);
  density.near_share = ratio(too_near, n);
  return density;
}

void measure_density(const Flown& flown, Measured& result) {
  Measures& m = result.measures;
  int late = 0;
  for (std::size_t tick = 0; tick <= flown.ticks(); tick += kTicksASample) {
    const Density density = density_of(flown.places(tick));
    result.curves.clumping.emplace_back(static_cast<double>(tick) * kPeriod, density.clumping);
    m.clumping_peak = std::max(m.clumping_peak, density.clumping);
    if (2 * tick >= flown.ticks()) {
      ++late;
      m.clumping += density.clumping;
      m.density_variation += density.variation;
      m.near_share += density.near_share;
    }
  }
  for (double* mean : {&m.clumping, &m.density_variation, &m.near_share}) {
    *mean /= std::max(late, 1);
  }
}

void measure_paths(const Flown& flown, double cruise_speed, Measures& m) {
  const std::size_t ticks = flown.ticks();
  const std::size_t last = std::min(ticks, ticks_in(5.0));
  std::vector<double> tortuosity;
  for (std::size_t a = 0; a < flown.agents; ++a) {
    double path = 0.0;
    for (std::size_t tick = 0; tick < ticks; ++tick) {
      path += static_cast<double>(glm::distance(flown.places(tick)[a], flown.places(tick + 1)[a]));
    }
    const double way = static_cast<double>(glm::distance(flown.places(0)[a], flown.places(ticks)[a]));
    tortuosity.push_back(ratio(path, std::max(way, 1e-3)));
    m.progress += ratio(way, cruise_speed * kPeriod * static_cast<double>(ticks));
    m.stuck_share += glm::distance(flown.places(ticks - last)[a], flown.places(ticks)[a]) < 1.0F ? 1.0 : 0.0;
  }
  const auto middle = tortuosity.begin() + static_cast<std::ptrdiff_t>(tortuosity.size() / 2);
  std::nth_element(tortuosity.begin(), middle, tortuosity.end());
  m.tortuosity = *middle;
  m.progress /= static_cast<double>(flown.agents);
  m.stuck_share /= static_cast<double>(flown.agents);
}

void measure_reach(const Flown& flown, Measures& m) {
  const std::size_t second = ticks_in(1.0);
  double carried2 = 0.0, speed2 = 0.0, seconds = 0.0;
  for (std::size_t a = 0; a < flown.agents; ++a) {
    for (std::size_t first = 0; first + second <= flown.ticks(); first += second) {
      glm::dvec3 way(0);
      for (std::size_t tick = first; tick < first + second; ++tick) {
        const glm::dvec3 v(flown.noises(tick)[a]);
        way += v * kPeriod;
        speed2 += glm::dot(v, v) * kPeriod;
      }
      carried2 += glm::dot(way, way);
      seconds += 1.0;
    }
  }
  m.noise_reach = std::sqrt(ratio(ratio(carried2, seconds), ratio(speed2, seconds)));
}

// How fast an agent turns about the vertical, rad/s. One that all but stands has no heading, and does not
// turn.
std::vector<double> turning_rates(const Flown& flown, std::size_t agent, double cruise_speed) {
  const double least = 0.01 * cruise_speed * kPeriod;
  std::vector<double> rates;
  std::optional<double> before;
  for (std::size_t tick = 0; tick < flown.ticks(); ++tick) {
    const glm::dvec3 step = glm::dvec3(flown.places(tick + 1)[agent]) - glm::dvec3(flown.places(tick)[agent]);
    std::optional<double> heading;
    if (std::hypot(step.x, step.y) > least) {
      heading = std::atan2(step.y, step.x);
    }
    const bool turns = heading && before;
    rates.push_back(turns ? std::remainder(*heading - *before, 2.0 * std::numbers::pi) / kPeriod : 0.0);
    before = heading;
  }
  return rates;
}

void measure_turning(const Flown& flown, double cruise_speed, Measured& result) {
  Spectrum spectrum(kWindow, kPeriod);
  double square = 0.0;
  for (std::size_t a = 0; a < flown.agents; ++a) {
    const std::vector<double> rates = turning_rates(flown, a, cruise_speed);
    square += std::inner_product(rates.begin(), rates.end(), rates.begin(), 0.0);
    spectrum.add(rates);
  }
  result.measures.turning_rate = std::sqrt(square / static_cast<double>(flown.agents * flown.ticks()));
  result.measures.turning_hz = spectrum.centroid();
  result.measures.turning_high = spectrum.upper_half();
  const auto shares = spectrum.shares();
  for (std::size_t k = 1; k + 1 < shares.size(); ++k) {
    result.curves.turning.emplace_back(spectrum.frequency(k), shares[k] / spectrum.frequency(1));
  }
}

}  // namespace

Measured measure(const Flown& flown, double cruise_speed) {
  Measured result;
  if (flown.agents == 0 || flown.ticks() == 0) {
    return result;
  }
  measure_density(flown, result);
  measure_paths(flown, cruise_speed, result.measures);
  measure_reach(flown, result.measures);
  measure_turning(flown, cruise_speed, result);
  return result;
}

}  // namespace mayfly::bench
