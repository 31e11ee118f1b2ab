// The OpenCL engine: the same kernels on whatever device there is. Fields go to the device once, positions
// every tick.
#include <algorithm>
#include <array>
#include <optional>
#include <thread>

#include "compute/buffer.hpp"
#include "compute/program.hpp"
#include "controller/engine/engine.hpp"
#include "controller/engine/minimum_distance.hpp"
#include "controller/engine/moment.hpp"
#include "controller/engine/opencl_avoidance.hpp"
#include "controller/engine/opencl_forces.hpp"
#include "controller/engine/opencl_transfer.hpp"
#include "controller/engine/permutation.hpp"

namespace mayfly {
namespace {

using compute::Buffer;
using compute::Device;
using compute::Kernel;
using compute::Status;
using opencl::kGroup;
using opencl::whole_groups;

// Three columns that travel together.
struct Columns3 {
  Buffer<float> x, y, z;

  static Result<Columns3> create(const Device& device, std::size_t count) {
    auto x = Buffer<float>::create(device, count);
    auto y = Buffer<float>::create(device, count);
    auto z = Buffer<float>::create(device, count);
    for (auto* buffer : {&x, &y, &z}) {
      if (!*buffer) {
        return fail(std::move(buffer->error()));
      }
    }
    return Columns3{std::move(*x), std::move(*y), std::move(*z)};
  }
  Status map() noexcept {
    return each([](Buffer<float>& b) { return b.map(); });
  }
  Status unmap() noexcept {
    return each([](Buffer<float>& b) { return b.unmap(); });
  }

  // Host to device. Leaves the columns with the device.
  Status upload(std::span<const float> from_x, std::span<const float> from_y,
                std::span<const float> from_z) noexcept {
    if (const Status status = map(); !status.ok()) {
      return status;
    }
    std::copy(from_x.begin(), from_x.end(), x.data().begin());
    std::copy(from_y.begin(), from_y.end(), y.data().begin());
    std::copy(from_z.begin(), from_z.end(), z.data().begin());
    return unmap();
  }
  // Device to host, after all that is enqueued.
  Status download(std::span<float> to_x, std::span<float> to_y, std::span<float> to_z) noexcept {
    if (const Status status = map(); !status.ok()) {
      return status;
    }
    std::copy_n(x.data().begin(), to_x.size(), to_x.begin());
    std::copy_n(y.data().begin(), to_y.size(), to_y.begin());
    std::copy_n(z.data().begin(), to_z.size(), to_z.begin());
    return unmap();
  }

 private:
  template <class Call>
  Status each(Call call) noexcept {
    for (Buffer<float>* buffer : {&x, &y, &z}) {
      if (const Status status = call(*buffer); !status.ok()) {
        return status;
      }
    }
    return {};
  }
};

// A swarm's own tables on the device.
struct SwarmTables {
  Buffer<float> walls, guide;
  Columns3 rest;
};

Result<SwarmTables> upload_tables(const Device& device, const SwarmModel& swarm) {
  auto walls = Buffer<float>::create_from(device, swarm.walls);
  auto guide = Buffer<float>::create_from(device, swarm.guide);
  auto rest = Columns3::create(device, swarm.count + MF_LANES);
  if (!walls || !guide || !rest) {
    return fail(Cause::kEnvironment, "OpenCL: no memory for the fields of a swarm");
  }
  if (const Status status = rest->upload(swarm.rest.x, swarm.rest.y, swarm.rest.z); !status.ok()) {
    return fail(Cause::kEnvironment, "OpenCL buffer: " + std::string(compute::name_of(status)));
  }
  return SwarmTables{std::move(*walls), std::move(*guide), std::move(*rest)};
}

// What exists once the agents are known.
struct Flying {
  std::size_t agents;
  Columns3 at, velocity;       // in the agents' order
  Columns3 ahead;              // one a slot
  Columns3 sorted, displaced;  // in the order of cells
  Buffer<float> half_distance;
  Buffer<unsigned char> pushed;
  Buffer<int> order, id, start, permutation;
  std::vector<SwarmTables> tables;
};

Result<Flying> make_flying(const Device& device, std::span<const SwarmModel> swarms, std::size_t agents) {
  const std::size_t padded = agents + MF_LANES;
  std::array<Result<Columns3>, 5> columns{Columns3::create(device, padded), Columns3::create(device, padded),
                                          Columns3::create(device, padded), Columns3::create(device, padded),
                                          Columns3::create(device, padded)};
  for (auto& result : columns) {
    if (!result) {
      return fail(std::move(result.error()));
    }
  }
  auto half_distance = Buffer<float>::create(device, padded);
  auto pushed = Buffer<unsigned char>::create(device, padded);
  auto order = Buffer<int>::create(device, padded);
  auto id = Buffer<int>::create(device, padded);
  auto start = Buffer<int>::create(device, CellOrder::most_starts(agents));
  auto permutation = Buffer<int>::create_from(device, kPermutation);
  if (!half_distance || !pushed || !order || !id || !start || !permutation) {
    return fail(Cause::kEnvironment, "OpenCL: no memory for " + std::to_string(agents) + " agents");
  }
  std::vector<SwarmTables> tables;
  for (const SwarmModel& swarm : swarms) {
    auto uploaded = upload_tables(device, swarm);
    if (!uploaded) {
      return fail(std::move(uploaded.error()));
    }
    tables.push_back(std::move(*uploaded));
  }
  return Flying{agents,
                std::move(*columns[0]),
                std::move(*columns[1]),
                std::move(*columns[2]),
                std::move(*columns[3]),
                std::move(*columns[4]),
                std::move(*half_distance),
                std::move(*pushed),
                std::move(*order),
                std::move(*id),
                std::move(*start),
                std::move(*permutation),
                std::move(tables)};
}

class OpenclEngine final : public Engine, private FirstSweep {
 public:
  OpenclEngine(Device device, Kernel velocity, Kernel displacement)
      : device_(std::move(device)),
        velocity_(std::move(velocity)),
        displacement_(std::move(displacement)),
        team_(static_cast<int>(std::thread::hardware_concurrency())) {}

  std::string_view name() const noexcept override { return "opencl"; }
  std::string_view fault() const noexcept override { return fault_; }

  Result<void> prepare(std::span<const SwarmModel> swarms, std::size_t agents) override {
    swarms_.assign(swarms.begin(), swarms.end());
    auto flying = make_flying(device_, swarms_, agents);
    if (!flying) {
      return fail(std::move(flying.error()));
    }
    flying_.emplace(std::move(*flying));
    upload_fault_ = {};
    seen_.prepare(swarms_, agents, team_.size());
    minimum_distance_.prepare(swarms_, agents);
    if (auto prepared = prepare_forces(); !prepared) {
      return prepared;
    }
    return seen_.on() ? prepare_avoidance(agents) : Result<void>{};
  }

  void replace_fields(std::size_t swarm, const SwarmFields& fields) noexcept override {
    upload_fault_ = {};
    replace(swarms_[swarm], fields);
    SwarmTables& tables = flying_->tables[swarm];
    for (const Status status :
         {replace_table(tables.walls, fields.walls), replace_table(tables.guide, fields.guide)}) {
      if (!status.ok()) {
        upload_fault_ = compute::name_of(status);
      }
    }
  }

  void move_stimuli(std::size_t swarm, std::span<const glm::vec3> places) noexcept override {
    place_stimuli(swarms_[swarm], places);
  }

  TickCounts compute(const AgentColumns& at, const TickTime& tick,
                     const VelocityColumns& out) noexcept override {
    // Fields that did not arrive on the device are a fault for as long as they are not replaced: nobody flies
    // by half a table.
    fault_ = upload_fault_;
    if (fault_.empty()) {
      Status status = velocities(at, tick, out);
      status = status.ok() ? forced_velocities(at, tick, out) : status;
      if (!status.ok()) {
        fault_ = compute::name_of(status);
      }
    }
    std::size_t infeasible = 0;
    if (fault_.empty() && seen_.on()) {
      if (const Status status = avoid(at, tick.period_s, out, infeasible); !status.ok()) {
        fault_ = compute::name_of(status);
      }
    }
    if (seen_.on() || forces_) {
      minimum_distance_.look_ahead({at.x, at.y, at.z}, tick.period_s, out, team_);
    }
    const std::size_t moved =
        fault_.empty() ? minimum_distance_.enforce({at.x, at.y, at.z}, tick.period_s, out, *this, team_) : 0;
    if (!fault_.empty()) {
      for (const std::span<float> column : {out.x, out.y, out.z}) {
        std::fill(column.begin(), column.end(), 0.0F);
      }
    }
    return {moved, fault_.empty() ? infeasible : 0};
  }

 private:
  Status velocities(const AgentColumns& at, const TickTime& tick, const VelocityColumns& out) noexcept {
    Flying& f = *flying_;
    const std::array<Status, 4> readied{f.at.upload(at.x, at.y, at.z),
                                        upload(f.order, minimum_distance_.order()), f.velocity.unmap(),
                                        f.ahead.unmap()};
    for (const Status status : readied) {
      if (!status.ok()) {
        return status;
      }
    }
    for (std::size_t s = 0; s < swarms_.size(); ++s) {
      const SwarmModel& swarm = swarms_[s];
      if (swarm.motor != Motor::kField) {
        continue;
      }
      const SwarmTables& tables = f.tables[s];
      const Status set = velocity_.set(
          f.at.x, f.at.y, f.at.z, f.order, tables.rest.x, tables.rest.y, tables.rest.z, f.velocity.x,
          f.velocity.y, f.velocity.z, f.ahead.x, f.ahead.y, f.ahead.z, static_cast<int>(swarm.first),
          static_cast<int>(swarm.count), tick.period_s, swarm.field,
          moment_of(swarm.field.noise, tick.number, tick.time_s), tables.walls, tables.guide, f.permutation);
      if (!set.ok()) {
        return set;
      }
      const std::size_t items = (swarm.count + MF_LANES - 1) / MF_LANES;
      if (const Status status = velocity_.enqueue(whole_groups(items), kGroup); !status.ok()) {
        return status;
      }
    }
    if (const Status status = f.velocity.download(out.x, out.y, out.z); !status.ok()) {
      return status;
    }
    const VelocityColumns ahead = minimum_distance_.ahead();
    return f.ahead.download(ahead.x, ahead.y, ahead.z);
  }

  // Its kernels are large: only who needs them waits for their being built.
  Result<void> prepare_forces() {
    const auto is_forced = [](const SwarmModel& swarm) { return swarm.motor != Motor::kField; };
    forces_.reset();
    if (std::none_of(swarms_.begin(), swarms_.end(), is_forced)) {
      return {};
    }
    auto forces = OpenclForces::create(device_);
    if (!forces) {
      return fail(std::move(forces.error()));
    }
    forces_.emplace(std::move(*forces));
    return forces_->prepare(device_, swarms_);
  }

  // The same.
  Result<void> prepare_avoidance(std::size_t agents) {
    auto avoidance = OpenclAvoidance::create(device_);
    if (!avoidance) {
      return fail(std::move(avoidance.error()));
    }
    avoidance_.emplace(std::move(*avoidance));
    return avoidance_->prepare(device_, agents);
  }

  // In place of what the field model left there.
  Status forced_velocities(const AgentColumns& at, const TickTime& tick,
                           const VelocityColumns& out) noexcept {
    for (std::size_t which = 0; forces_ && which < forces_->forced(); ++which) {
      const std::size_t swarm = forces_->swarm_of(which);
      const OpenclForces::Tables tables{flying_->tables[swarm].walls, flying_->permutation};
      const Status status = forces_->compute(which, swarms_[swarm], at, tick, tables, out, team_);
      if (!status.ok()) {
        return status;
      }
    }
    return {};
  }

  Status avoid(const AgentColumns& at, float period_s, const VelocityColumns& out,
               std::size_t& infeasible) noexcept {
    seen_.look_round(at, team_);
    if (const Status status = avoidance_->upload(seen_, out); !status.ok()) {
      return status;
    }
    for (std::size_t s = 0; s < swarms_.size(); ++s) {
      const Status status = avoidance_->start(seen_, s, swarms_[s], flying_->tables[s].walls, period_s);
      if (!status.ok()) {
        return status;
      }
    }
    return avoidance_->download(seen_, out, infeasible);
  }

  void first_sweep(const CellOrder& order, SearchReach reach, Displacements& out) noexcept override {
    if (const Status status = sweep(order, reach, out); !status.ok()) {
      fault_ = compute::name_of(status);
      std::fill(out.pushed.begin(), out.pushed.end(), std::uint8_t{0});
    }
  }

  template <class T>
  static Status upload(Buffer<T>& buffer, std::span<const T> from) noexcept {
    if (const Status status = buffer.map(); !status.ok()) {
      return status;
    }
    std::copy_n(from.begin(), std::min(from.size(), buffer.size()), buffer.data().begin());
    return buffer.unmap();
  }

  static Status replace_table(Buffer<float>& table, std::span<const float> from) noexcept {
    return from.empty() ? Status{} : upload(table, from);
  }

  Status sweep(const CellOrder& order, SearchReach reach, Displacements& out) noexcept {
    Flying& f = *flying_;
    const std::array<Status, 7> readied{
        f.sorted.upload(order.x(), order.y(), order.z()),
        upload(f.half_distance, order.half_distance()),
        upload(f.id, order.id()),
        upload(f.start, order.start().first(order.cell_count() + 1)),
        f.displaced.unmap(),
        f.pushed.unmap(),
        displacement_.set(order.cells(), f.start, f.sorted.x, f.sorted.y, f.sorted.z, f.half_distance, f.id,
                          reach.farthest, reach.slack, f.displaced.x, f.displaced.y, f.displaced.z, f.pushed,
                          static_cast<int>(f.agents))};
    for (const Status status : readied) {
      if (!status.ok()) {
        return status;
      }
    }
    const std::size_t items = (f.agents + MF_LANES - 1) / MF_LANES;
    if (const Status status = displacement_.enqueue(whole_groups(items), kGroup); !status.ok()) {
      return status;
    }
    if (const Status status = f.displaced.download(out.x, out.y, out.z); !status.ok()) {
      return status;
    }
    if (const Status status = f.pushed.map(); !status.ok()) {
      return status;
    }
    std::copy_n(f.pushed.data().begin(), f.agents, out.pushed.begin());
    return {};
  }

  Device device_;
  Kernel velocity_;
  std::optional<OpenclForces> forces_;
  std::optional<OpenclAvoidance> avoidance_;
  Kernel displacement_;
  ThreadTeam team_;
  std::vector<SwarmModel> swarms_;
  std::optional<Flying> flying_;
  Avoidance seen_;
  MinimumDistance minimum_distance_;
  std::string_view fault_{};
  std::string_view upload_fault_{};
};

Result<Kernel> build_kernel(const Device& device, std::string_view program, const std::string& kernel) {
  return compute::Program::build(device, program).and_then([&](const compute::Program& p) {
    return p.kernel(kernel);
  });
}

}  // namespace

Result<std::unique_ptr<Engine>> make_opencl_engine() {
  auto device = Device::open();
  if (!device) {
    return fail(std::move(device.error()));
  }
  auto velocity = build_kernel(*device, "field", "field_velocity");
  if (!velocity) {
    return fail(std::move(velocity.error()));
  }
  auto displacement = build_kernel(*device, "mde", "displacement");
  if (!displacement) {
    return fail(std::move(displacement.error()));
  }
  return std::make_unique<OpenclEngine>(std::move(*device), std::move(*velocity), std::move(*displacement));
}

}  // namespace mayfly
