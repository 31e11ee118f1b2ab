#include "controller/governor/neighbour_cells.hpp"

#include <algorithm>
#include <cmath>

#include "controller/governor/capsule.hpp"

namespace mayfly {
namespace {

constexpr double kMostCells = 64.0;  // an axis

}  // namespace

NeighbourCells::NeighbourCells(std::size_t agents, const Box& box, double usual)
    : usual_(usual), origin_(box.min), sorted_(agents), cell_of_(agents), wide_(agents), found_(agents) {
  for (int axis = 0; axis < 3; ++axis) {
    const double size = static_cast<double>(box.max[axis]) - static_cast<double>(box.min[axis]);
    side_[axis] = std::max({2.0 * usual, size / kMostCells, 1e-3});
    cells_[axis] = static_cast<int>(std::clamp(std::ceil(size / side_[axis]), 1.0, kMostCells));
  }
  starts_.resize(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) *
                     static_cast<std::size_t>(cells_.z) +
                 1);
}

// Places outside belong to the cells at the border, which keeps neighbours neighbours.
int NeighbourCells::cell_along(double coordinate, int axis) const noexcept {
  const double cell = std::floor((coordinate - origin_[axis]) / side_[axis]);
  return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(cells_[axis] - 1)));
}

std::size_t NeighbourCells::cell_of(glm::dvec3 place) const noexcept {
  const auto row = static_cast<std::size_t>(cell_along(place.z, 2)) * static_cast<std::size_t>(cells_.y) +
                   static_cast<std::size_t>(cell_along(place.y, 1));
  return row * static_cast<std::size_t>(cells_.x) + static_cast<std::size_t>(cell_along(place.x, 0));
}

void NeighbourCells::sort(std::span<const Ball> balls) noexcept {
  std::fill(starts_.begin(), starts_.end(), 0U);
  sorted_count_ = wide_count_ = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls[i].radius > usual_) {
      wide_[wide_count_++] = static_cast<std::uint32_t>(i);
    } else if (balls[i].radius >= 0.0) {
      cell_of_[i] = static_cast<std::uint32_t>(cell_of(balls[i].center));
      ++starts_[cell_of_[i]];
      ++sorted_count_;
    }
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& start : starts_) {
    sum += start;
    start = sum;  // the end of the cell; each agent that comes in moves it to the front
  }
  for (std::size_t i = balls.size(); i-- > 0;) {
    if (balls[i].radius >= 0.0 && balls[i].radius <= usual_) {
      sorted_[--starts_[cell_of_[i]]] = static_cast<std::uint32_t>(i);
    }
  }
}

std::span<const std::uint32_t> NeighbourCells::near(std::size_t agent, std::span<const Ball> balls) noexcept {
  found_count_ = 0;
  const Ball& ball = balls[agent];
  look_at({wide_.data(), wide_count_}, agent, balls);
  if (ball.radius > usual_) {
    look_at({sorted_.data(), sorted_count_}, agent, balls);
    return {found_.data(), found_count_};
  }
  const glm::ivec3 at(cell_along(ball.center.x, 0), cell_along(ball.center.y, 1),
                      cell_along(ball.center.z, 2));
  const int low_x = std::max(at.x - 1, 0);
  const int high_x = std::min(at.x + 1, cells_.x - 1);
  for (int z = std::max(at.z - 1, 0); z <= std::min(at.z + 1, cells_.z - 1); ++z) {
    for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, cells_.y - 1); ++y) {
      const auto row =
          static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_.y) + static_cast<std::size_t>(y);
      const std::size_t begin = row * static_cast<std::size_t>(cells_.x);
      const std::uint32_t first = starts_[begin + static_cast<std::size_t>(low_x)];
      const std::uint32_t last = starts_[begin + static_cast<std::size_t>(high_x) + 1];
      look_at({sorted_.data() + first, last - first}, agent, balls);
    }
  }
  return {found_.data(), found_count_};
}

void NeighbourCells::look_at(std::span<const std::uint32_t> others, std::size_t agent,
                             std::span<const Ball> balls) noexcept {
  const Ball& ball = balls[agent];
  for (const std::uint32_t other : others) {
    const glm::dvec3 way = balls[other].center - ball.center;
    const double reach = balls[other].radius + ball.radius;
    if (other != agent && dot3(way, way) <= reach * reach) {
      found_[found_count_++] = other;
    }
  }
}

}  // namespace mayfly
