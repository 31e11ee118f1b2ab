// An axis of a chart: from values to places along it, and where its ticks are.
#pragma once

#include <string>
#include <vector>

namespace mayfly::record {

struct Tick {
  double value = 0.0;
  std::string label;  // empty between the round ones of a logarithmic axis
};

class ChartScale {
 public:
  // Values from `least` to `most`; a logarithmic one leaves out what is not above 0. Where there is no range
  // (least ≥ most, or no numbers), one is made up around them.
  ChartScale(double least, double most, bool logarithmic);

  double least() const { return least_; }
  double most() const { return most_; }
  // Whether `value` has a place at all.
  bool shows(double value) const;
  // 0 at `least`, 1 at `most`; beyond them outside [0, 1].
  double fraction(double value) const;
  // At round values, about `spacing` px from each other on an axis of `length` px.
  std::vector<Tick> ticks(double length, double spacing) const;

 private:
  std::vector<Tick> decades() const;

  double least_, most_;
  bool logarithmic_;
};

}  // namespace mayfly::record
