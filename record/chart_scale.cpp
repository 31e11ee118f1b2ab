#include "record/chart_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "record/plot_drawing.hpp"

namespace mayfly::record {
namespace {

std::string plain_label(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", std::fabs(value) < 1e-12 ? 0.0 : value);
  return text.data();
}

// "10⁵": powers that are too long to be written out.
std::string power_label(int exponent) {
  static constexpr std::array<const char*, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent >= -3 && exponent <= 3) {
    return plain_label(std::pow(10.0, exponent));
  }
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += kRaised[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

}  // namespace

ChartScale::ChartScale(double least, double most, bool logarithmic)
    : least_(least), most_(most), logarithmic_(logarithmic) {
  if (logarithmic) {
    most_ = std::isfinite(most_) && most_ > 0.0 ? most_ : 10.0;
    least_ = std::isfinite(least_) && least_ > 0.0 ? least_ : most_ / 10.0;
    if (least_ >= most_) {
      least_ /= 3.0;
      most_ = 9.0 * least_;
    }
    return;
  }
  least_ = std::isfinite(least_) ? least_ : 0.0;
  most_ = std::isfinite(most_) ? most_ : least_ + 1.0;
  if (least_ >= most_) {
    const double half = std::max(0.5 * std::fabs(least_), 0.5);
    most_ = least_ + half;
    least_ -= half;
  }
}

bool ChartScale::shows(double value) const {
  return std::isfinite(value) && (!logarithmic_ || value > 0.0);
}

double ChartScale::fraction(double value) const {
  return logarithmic_ ? std::log(value / least_) / std::log(most_ / least_)
                      : (value - least_) / (most_ - least_);
}

std::vector<Tick> ChartScale::decades() const {
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(least_) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(most_) - 1e-9));
  const bool few = last - first <= 2;
  const int every = 1 + (last - first) / 10;
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10.0, exponent);
      if (value < least_ * (1.0 - 1e-9) || value > most_ * (1.0 + 1e-9)) {
        continue;
      }
      const bool labelled = digit == 1 ? exponent % every == 0 : few && (digit == 2 || digit == 5);
      if (labelled) {
        ticks.push_back({value, digit == 1 ? power_label(exponent) : plain_label(value)});
      } else if (every == 1) {
        ticks.push_back({value, ""});
      }
    }
  }
  return ticks;
}

std::vector<Tick> ChartScale::ticks(double length, double spacing) const {
  if (logarithmic_) {
    return decades();
  }
  std::vector<Tick> ticks;
  for (const double value : round_ticks(least_, most_, length / (most_ - least_), spacing)) {
    ticks.push_back({value, plain_label(value)});
  }
  return ticks;
}

}  // namespace mayfly::record
