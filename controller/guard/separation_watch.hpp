// Whether two robots could touch if everybody braked now, worked out from the estimates and from what is
// sent, apart from the governor's own account.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace mayfly {

// From where a robot is to where it would rest: a segment with a radius, m. Heights of two are divided by the
// smaller of their two `downwash` before they are measured.
struct StoppingPath {
  glm::dvec3 from{0.0}, to{0.0};
  double radius = 0.0;
  double downwash = 1.0;
  bool counts = false;  // false: nothing is known of it, or it is not ours
};

// The distance of two segments, m.
double segment_distance(const glm::dvec3& a0, const glm::dvec3& a1, const glm::dvec3& b0,
                        const glm::dvec3& b1) noexcept;

// Sweeps along x: robots are kept in order from tick to tick, so that sorting costs next to nothing.
class SeparationWatch {
 public:
  explicit SeparationWatch(std::size_t robots);

  // Calls `touch(i, j)` for each pair whose paths come nearer than the sum of their radii, by more than
  // rounding.
  template <class Touch>
  void check(std::span<const StoppingPath> paths, const Touch& touch) noexcept {
    sort(paths);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const std::uint32_t i = order_[k];
      for (std::size_t other = k + 1; other < order_.size() && low_[order_[other]] <= high_[i]; ++other) {
        if (touches(paths[i], paths[order_[other]])) {
          touch(i, order_[other]);
        }
      }
    }
  }

 private:
  static bool touches(const StoppingPath& a, const StoppingPath& b) noexcept;
  void sort(std::span<const StoppingPath> paths) noexcept;

  std::vector<std::uint32_t> order_;
  std::vector<double> low_, high_;  // m along x, radius included; by robot
};

}  // namespace mayfly
