#include "bench/noise/lanes.hpp"
#include "bench/noise/steering.hpp"

namespace mayfly::bench {
namespace {

class Path final : public Steering {
 public:
  explicit Path(const Arena& arena) : arena_(arena) {}
  void steer(std::span<const glm::vec3> at, std::span<glm::vec3> velocity) override {
    guided_velocities(arena_, at, velocity);
  }

 private:
  const Arena& arena_;
};

}  // namespace

void guided_velocities(const Arena& arena, std::span<const glm::vec3> at, std::span<glm::vec3> velocity) {
  const kernels::MfTables tables = arena.tables();
  for (std::size_t a = 0; a < at.size(); a += MF_LANES) {
    const kernels::F3 r = lanes_of(at, a);
    const kernels::MfAround around = kernels::mf_around(r, nullptr, &arena.field.grid);
    kernels::F cost;
    const kernels::F3 v =
        kernels::mf_global_velocity(r, kernels::mf_isplat(0), &around, &arena.field, &tables, &cost);
    store_lanes(v, velocity, a);
  }
}

std::unique_ptr<Steering> make_path(const Arena& arena) {
  return std::make_unique<Path>(arena);
}

}  // namespace mayfly::bench
