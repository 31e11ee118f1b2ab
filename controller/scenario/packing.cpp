#include "controller/scenario/packing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mayfly {
namespace {

double sphere_volume(double diameter) {
  return std::numbers::pi / 6.0 * diameter * diameter * diameter;
}

}  // namespace

double grown_box_volume(double x, double y, double z, double separation) {
  return (x + separation) * (y + separation) * (z + separation);
}

double grown_sphere_volume(double radius, double separation) {
  return sphere_volume(2.0 * radius + separation);
}

double packed_share(double count, double separation, double grown_volume) {
  return count * sphere_volume(separation) / grown_volume;
}

double count_that_fits(double separation, double grown_volume, double share) {
  return std::max(1.0, std::floor(share * grown_volume / sphere_volume(separation)));
}

}  // namespace mayfly
