#include "controller/engine/opencl_forces.hpp"

#include <algorithm>
#include <string>

#include "controller/engine/moment.hpp"
#include "controller/engine/opencl_transfer.hpp"

namespace mayfly {
namespace {

using compute::Buffer;
using compute::Device;
using compute::Kernel;
using compute::Status;
using opencl::first_fault;
using opencl::send;

Status send_columns(Buffer<float>& to, const NeighbourGrid& grid, std::size_t stride) noexcept {
  if (const Status status = to.map(); !status.ok()) {
    return status;
  }
  for (std::size_t column = 0; column < 6; ++column) {
    std::copy_n(grid.column(column).begin(), grid.count(),
                to.data().begin() + static_cast<std::ptrdiff_t>(column * stride));
  }
  return to.unmap();
}

}  // namespace

OpenclForces::OpenclForces(Kernel forces, Kernel boids, Kernel brownian)
    : forces_(std::move(forces)), boids_(std::move(boids)), brownian_(std::move(brownian)) {}

Result<OpenclForces> OpenclForces::create(const Device& device) {
  auto program = compute::Program::build(device, "forces");
  if (!program) {
    return fail(std::move(program.error()));
  }
  auto forces = program->kernel("forces_velocity");
  auto boids = program->kernel("boids_velocity");
  auto brownian = program->kernel("brownian_velocity");
  for (auto* kernel : {&forces, &boids, &brownian}) {
    if (!*kernel) {
      return fail(std::move(kernel->error()));
    }
  }
  return OpenclForces(std::move(*forces), std::move(*boids), std::move(*brownian));
}

Result<OpenclForces::Room> OpenclForces::make_room(const Device& device, const ForcedSwarm& forced,
                                                   const SwarmModel& model) {
  const std::size_t stride = model.count + MF_LANES;
  auto eights = Buffer<int>::create(device, NeighbourGrid::most_eights(model.count));
  auto start = Buffer<int>::create(device, NeighbourGrid::most_cells(model.count) + 1);
  auto id = Buffer<int>::create(device, stride);
  auto encounters = Buffer<int>::create(device, forced.encounters.size());
  auto sorted = Buffer<float>::create(device, 6 * stride);
  auto nodes = Buffer<float>::create(device, forced.far.nodes().size());
  auto field = Buffer<kernels::MfField>::create(device, 1);
  auto forces = Buffer<kernels::MfForces>::create(device, 1);
  auto vx = Buffer<float>::create(device, model.first + model.count);
  auto vy = Buffer<float>::create(device, model.first + model.count);
  auto vz = Buffer<float>::create(device, model.first + model.count);
  if (!eights || !start || !id || !encounters || !sorted || !nodes || !field || !forces || !vx || !vy ||
      !vz) {
    return fail(Cause::kEnvironment,
                "OpenCL: no memory for the forces on " + std::to_string(model.count) + " agents");
  }
  if (const Status status = encounters->unmap(); !status.ok()) {
    return fail(Cause::kEnvironment, "OpenCL buffer: " + std::string(compute::name_of(status)));
  }
  return Room{std::move(*eights), std::move(*start), std::move(*id),    std::move(*encounters),
              std::move(*sorted), std::move(*nodes), std::move(*field), std::move(*forces),
              std::move(*vx),     std::move(*vy),    std::move(*vz),    stride};
}

Result<void> OpenclForces::prepare(const Device& device, std::span<const SwarmModel> swarms) {
  forced_ = forced_swarms(swarms);
  rooms_.clear();
  for (const ForcedSwarm& forced : forced_) {
    auto room = make_room(device, forced, swarms[forced.swarm]);
    if (!room) {
      return fail(std::move(room.error()));
    }
    rooms_.push_back(std::move(*room));
  }
  return {};
}

Status OpenclForces::compute(std::size_t which, const SwarmModel& model, const AgentColumns& at,
                             const TickTime& tick, const Tables& tables, const VelocityColumns& out,
                             ThreadTeam& team) noexcept {
  ForcedSwarm& forced = forced_[which];
  Room& room = rooms_[which];
  sort_for_forces(forced, model, at, out, team);
  if (const Status status = upload(room, forced, model); !status.ok()) {
    return status;
  }
  if (const Status status = start(room, forced, model, tick, tables); !status.ok()) {
    return status;
  }
  return download(room, forced, out);
}

Status OpenclForces::upload(Room& room, const ForcedSwarm& forced, const SwarmModel& model) noexcept {
  const NeighbourGrid& grid = forced.grid;
  // Without a mesh nobody reads a node.
  const std::size_t nodes = forced.far.mesh().on != 0 ? forced.far.nodes().size() : 0;
  return first_fault(
      {send(room.eights, grid.eights()), send(room.start, grid.start()), send(room.id, grid.id()),
       send_columns(room.sorted, grid, room.stride), send(room.nodes, forced.far.nodes(), nodes),
       send(room.field, std::span(&model.field, 1)), send(room.model, std::span(&model.forces, 1)),
       room.vx.unmap(), room.vy.unmap(), room.vz.unmap()});
}

Status OpenclForces::start(Room& room, const ForcedSwarm& forced, const SwarmModel& model,
                           const TickTime& tick, const Tables& tables) noexcept {
  const kernels::MfMoment moment = moment_of(model.field.noise, tick.number, tick.time_s);
  const auto count = static_cast<int>(forced.grid.eight_count());
  const auto set = [&](Kernel& kernel, const auto&... own) {
    return kernel.set(room.eights, count, forced.grid.cubes(), room.start, room.sorted,
                      static_cast<int>(room.stride), room.id, room.field, moment, tables.walls,
                      tables.permutation, tick.period_s, model.avoidance.on != 0 ? 0 : 1, room.vx, room.vy,
                      room.vz, own...);
  };
  Kernel& kernel = model.motor == Motor::kForces  ? forces_
                   : model.motor == Motor::kBoids ? boids_
                                                  : brownian_;
  const Status status =
      model.motor == Motor::kForces
          ? set(kernel, room.model, forced.key, room.encounters, static_cast<int>(model.first),
                static_cast<int>(model.count), forced.far.mesh(), room.nodes)
      : model.motor == Motor::kBoids ? set(kernel, model.boids)
                                     : set(kernel, model.brownian);
  if (!status.ok()) {
    return status;
  }
  return kernel.enqueue(opencl::whole_groups(forced.grid.eight_count()), opencl::kGroup);
}

// Of the agents that were sorted; the absent have their velocity already.
Status OpenclForces::download(Room& room, const ForcedSwarm& forced, const VelocityColumns& out) noexcept {
  if (const Status status = first_fault({room.vx.map(), room.vy.map(), room.vz.map()}); !status.ok()) {
    return status;
  }
  for (const int agent : forced.grid.id().first(forced.grid.count())) {
    const auto a = static_cast<std::size_t>(agent);
    out.x[a] = room.vx.data()[a];
    out.y[a] = room.vy.data()[a];
    out.z[a] = room.vz.data()[a];
  }
  return {};
}

}  // namespace mayfly
