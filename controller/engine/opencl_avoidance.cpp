#include "controller/engine/opencl_avoidance.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "controller/engine/opencl_transfer.hpp"

namespace mayfly {
namespace {

using compute::Buffer;
using compute::Device;
using compute::Status;
using opencl::first_fault;
using opencl::send;

Status fetch(Buffer<float>& from, std::span<float> to) noexcept {
  if (const Status status = from.map(); !status.ok()) {
    return status;
  }
  std::copy_n(from.data().begin(), to.size(), to.begin());
  return {};
}

}  // namespace

OpenclAvoidance::OpenclAvoidance(compute::Kernel kernel) : kernel_(std::move(kernel)) {}

Result<OpenclAvoidance> OpenclAvoidance::create(const Device& device) {
  auto kernel = compute::Program::build(device, "orca").and_then([](const compute::Program& program) {
    return program.kernel("avoid");
  });
  if (!kernel) {
    return fail(std::move(kernel.error()));
  }
  return OpenclAvoidance(std::move(*kernel));
}

Result<void> OpenclAvoidance::prepare(const Device& device, std::size_t agents) {
  const std::size_t padded = agents + MF_LANES;
  auto body = Buffer<float>::create(device, 4 * padded);
  auto motion = Buffer<float>::create(device, 4 * padded);
  auto vx = Buffer<float>::create(device, padded);
  auto vy = Buffer<float>::create(device, padded);
  auto vz = Buffer<float>::create(device, padded);
  auto infeasible = Buffer<float>::create(device, padded);
  auto id = Buffer<int>::create(device, padded);
  auto nearest = Buffer<int>::create(device, kMostNearest * padded);
  auto slots = Buffer<int>::create(device, padded);
  if (!body || !motion || !vx || !vy || !vz || !infeasible || !id || !nearest || !slots) {
    return fail(Cause::kEnvironment,
                "OpenCL: no memory for the neighbours of " + std::to_string(agents) + " agents");
  }
  room_.emplace(Room{std::move(*body), std::move(*motion), std::move(*vx), std::move(*vy), std::move(*vz),
                     std::move(*infeasible), std::move(*id), std::move(*nearest), std::move(*slots)});
  return {};
}

Status OpenclAvoidance::upload(const Avoidance& seen, const VelocityColumns& velocity) noexcept {
  Room& room = *room_;
  const std::size_t count = seen.present();
  const std::size_t agents = velocity.x.size();
  return first_fault(
      {send(room.body, seen.body(), 4 * count), send(room.motion, seen.motion(), 4 * count),
       send(room.id, seen.id(), count), send(room.nearest, seen.nearest(), kMostNearest * count),
       send(room.slots, seen.slots(), agents + MF_LANES), send(room.vx, velocity.x, agents),
       send(room.vy, velocity.y, agents), send(room.vz, velocity.z, agents), room.infeasible.unmap()});
}

Status OpenclAvoidance::start(const Avoidance& seen, std::size_t swarm, const SwarmModel& model,
                              const Buffer<float>& walls, float period_s) noexcept {
  const std::size_t count = seen.slots_of(swarm).size();
  Room& room = *room_;
  const Status set = kernel_.set(room.body, room.motion, room.id, room.nearest, int{kMostNearest}, room.slots,
                                 static_cast<int>(model.first), static_cast<int>(count), room.vx, room.vy,
                                 room.vz, room.infeasible, period_s, model.avoidance, model.field, walls);
  const std::size_t items = (count + MF_LANES - 1) / MF_LANES;
  return set.ok() ? kernel_.enqueue(opencl::whole_groups(items), opencl::kGroup) : set;
}

Status OpenclAvoidance::download(const Avoidance& seen, const VelocityColumns& velocity,
                                 std::size_t& infeasible) noexcept {
  Room& room = *room_;
  const Status fetched = first_fault({fetch(room.vx, velocity.x), fetch(room.vy, velocity.y),
                                      fetch(room.vz, velocity.z), room.infeasible.map()});
  if (!fetched.ok()) {
    return fetched;
  }
  for (std::size_t s = 0; s < seen.swarms(); ++s) {
    const auto first = room.infeasible.data().begin() + static_cast<std::ptrdiff_t>(seen.first_slot(s));
    const auto count = static_cast<std::ptrdiff_t>(seen.slots_of(s).size());
    infeasible += static_cast<std::size_t>(std::count(first, first + count, 1.0F));
  }
  return {};
}

}  // namespace mayfly
