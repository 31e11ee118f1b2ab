// How long the fields of a large world take, and how many bytes: a city of boxes in a cube of 1 km, in cells
// of 1 m near them; against the dense grid's bytes, which nobody could hold.
#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include "fields/nested_cost.hpp"
#include "fields/nested_distance.hpp"

namespace mayfly {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Houses on a lattice with streets of 4 to 60 m, of heights that differ.
std::vector<fields::PlacedShape> city(int side) {
  std::vector<fields::PlacedShape> shapes;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const float x = 200.0F + 100.0F * static_cast<float>(i);
      const float y = 200.0F + 100.0F * static_cast<float>(j);
      const float width = 40.0F + 8.0F * static_cast<float>((3 * i + 5 * j) % 8);
      const float height = 80.0F + 40.0F * static_cast<float>((5 * i + 3 * j) % 10);
      shapes.push_back({fields::BoxShape{{{x, y, 0.0F}, {x + width, y + width, height}}}, {}});
    }
  }
  return shapes;
}

int run() {
  constexpr int kThreads = 2;
  const auto solid = fields::Geometry::make(city(6), 1.0F);
  const fields::PlacedShape goal_shape{fields::BoxShape{{{900, 480, 100}, {940, 520, 140}}}, {}};
  std::vector<fields::Geometry> goals;
  goals.push_back(*fields::Geometry::make({&goal_shape, 1}, 1.0F));
  auto start = Clock::now();
  auto field = fields::build_nested_distance(*solid, goals, {{0, 0, 0}, {1000, 1000, 1000}}, 1.0F,
                                             {5.0F, 2.0F, 3.0F}, kThreads, {});
  if (!field) {
    std::fprintf(stderr, "%s\n", field.error().message.c_str());
    return 1;
  }
  std::printf("distance %.2f s\n", seconds_since(start));
  start = Clock::now();
  const std::vector<float> walls = fields::nested_walls(*field, kThreads, {});
  std::printf("walls    %.2f s\n", seconds_since(start));
  const auto nested = std::make_shared<const NestedGrid>(field->nested);
  start = Clock::now();
  const auto cost = fields::build_nested_cost({nested, field->distance}, goals[0], {}, kThreads, {});
  std::printf("cost     %.2f s, %zu unreachable\n", seconds_since(start), cost ? cost->unreachable : 0);
  const double fine = 1e9;
  std::printf("%zu bricks, %zu entries: φ, walls and guide %.0f MB, %.0f times less than the dense grid\n",
              nested->bricks, nested->entries(), 24e-6 * static_cast<double>(nested->entries()),
              fine / static_cast<double>(nested->entries()));
  return 0;
}

}  // namespace
}  // namespace mayfly

int main() {
  return mayfly::run();
}
