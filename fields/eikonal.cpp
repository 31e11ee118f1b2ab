#include "fields/eikonal.hpp"

#include <atomic>
#include <barrier>
#include <cmath>
#include <memory>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "fields/eikonal_strips.hpp"

namespace mayfly::fields {
namespace {

using strips::Layout;
using strips::Outcome;
using strips::Range;

constexpr float kLargest = 1e12F;

Result<void> check_grid_of(const Grid& grid) {
  if (!(grid.cell > 0.0F) || !std::isfinite(grid.cell) || grid.cells.x < 1 || grid.cells.y < 1 ||
      grid.cells.z < 1) {
    return fail(Cause::kCaller, "the grid of a cost field needs at least one cell, of a positive side");
  }
  return {};
}

// Bitwise operators: without branches, eight cells are looked at together.
bool good_input(float slowness, float cost, float cell) {
  const bool slowness_good =
      (slowness <= 0.0F) | (slowness * cell <= kLargest) | (slowness == kUnreachedCost);
  return slowness_good & ((std::abs(cost) <= kLargest) | (cost == kUnreachedCost));
}

Result<void> check_input(const Grid& grid, std::span<const float> slowness, std::span<const float> cost) {
  if (slowness.size() != grid.size() || cost.size() != grid.size()) {
    return fail(Cause::kCaller, "the grid has " + std::to_string(grid.size()) + " cells, the slowness " +
                                    std::to_string(slowness.size()) + ", the cost " +
                                    std::to_string(cost.size()));
  }
  bool good = true;
  for (std::size_t at = 0; at < slowness.size(); ++at) {
    good &= good_input(slowness[at], cost[at], grid.cell);
  }
  for (std::size_t at = 0; !good && at < slowness.size(); ++at) {
    if (!good_input(slowness[at], cost[at], grid.cell)) {
      return fail(Cause::kCaller, "cell " + std::to_string(at) + " of the cost field has slowness " +
                                      std::to_string(slowness[at]) + " and source cost " +
                                      std::to_string(cost[at]) + ": not a number, or too large");
    }
  }
  return {};
}

struct FreeArray {
  void operator()(float* p) const { ::operator delete[](p, std::align_val_t(64)); }
};
using Table = std::unique_ptr<float[], FreeArray>;

// Not initialised here: the threads that will work on it fill it.
Table make_table(std::size_t size) {
  return Table(static_cast<float*>(::operator new[](size * sizeof(float), std::align_val_t(64))));
}

// The work that waits in a brick, by who left it there: each is written by one thread at a time.
struct Pending {
  Range own;         // by bricks of the same planes
  Range from_below;  // by the brick below in z
  Range from_above;
  Range stale;  // cells that changed since the other layout was brought up to date
};

}  // namespace

class EikonalSolver::Sweeper {
 public:
  explicit Sweeper(const Grid& grid) : grid_(grid), layout_(grid.cells) {
    for (int side = 0; side < 2; ++side) {
      costs_[side] = make_table(layout_.size());
      steps_[side] = make_table(layout_.size());
    }
    pending_.resize(static_cast<std::size_t>(layout_.bricks) * static_cast<std::size_t>(layout_.strips));
    done_ = std::make_unique<Counter[]>(static_cast<std::size_t>(layout_.bricks));
  }

  const Grid& grid() const { return grid_; }

  EikonalStats run(std::span<const float> slowness, std::span<float> cost, unsigned threads,
                   const std::function<void(int)>& progress) {
    slowness_ = slowness;
    cost_ = cost;
    progress_ = &progress;
    threads_ = std::clamp(threads, 1U, static_cast<unsigned>(layout_.bricks));
    sweeps_ = 0;
    last_busy_ = -1;
    updates_ = 0;
    std::fill(pending_.begin(), pending_.end(), Pending{});
    std::vector<std::thread> helpers;
    std::atomic<bool> started{false};
    for (unsigned thread = 1; thread < threads_; ++thread) {
      try {
        helpers.emplace_back([this, &started, thread] {
          started.wait(false);
          work(thread);
        });
      } catch (const std::system_error&) {
        break;  // the machine gives no more threads: fewer do the same
      }
    }
    threads_ = static_cast<unsigned>(helpers.size()) + 1;
    if (threads_ > 1) {
      barrier_ = std::make_unique<std::barrier<>>(threads_);
    }
    started = true;
    started.notify_all();
    work(0);
    for (std::thread& helper : helpers) {
      helper.join();
    }
    return {sweeps_, updates_.load()};
  }

 private:
  struct alignas(64) Counter {
    std::atomic<int> strips{0};  // of the current sweep
  };

  void wait_for_all() {
    if (threads_ > 1) {
      barrier_->arrive_and_wait();
    }
  }

  // What every thread does, in step with the others. Eight directions take turns: four on each layout.
  void work(unsigned thread) {
    constexpr bool kForward[] = {true, false, true, false};
    constexpr bool kUpward[] = {true, false, false, true};
    for_own_bricks(thread, [&](int brick) { load(brick); });
    bool flipped = false;
    bool busy = true;
    for (int sweep = 0; busy; ++sweep) {
      if (sweep > 0 && sweep % 4 == 0) {
        for_own_bricks(thread, [&](int brick) { flip(brick, flipped); });
        flipped = !flipped;
      }
      for_own_bricks(thread, [&](int brick) { counter(brick).store(0, std::memory_order_relaxed); });
      wait_for_all();
      if (run_sweep(thread, flipped, kForward[sweep % 4], kUpward[sweep % 4])) {
        last_busy_.store(sweep, std::memory_order_relaxed);
      }
      wait_for_all();
      busy = last_busy_.load(std::memory_order_relaxed) == sweep;
      if (thread == 0) {
        sweeps_ = sweep + 1;
        if (*progress_) {
          (*progress_)(sweeps_);
        }
      }
    }
    for_own_bricks(thread, [&](int brick) { store(brick, flipped); });
  }

  template <class Function>
  void for_own_bricks(unsigned thread, Function function) {
    for (int brick = static_cast<int>(thread); brick < layout_.bricks; brick += static_cast<int>(threads_)) {
      function(brick);
    }
  }

  std::atomic<int>& counter(int brick) { return done_[static_cast<std::size_t>(brick)].strips; }

  Pending& pending(int brick, int strip) {
    return pending_[static_cast<std::size_t>(brick) * static_cast<std::size_t>(layout_.strips) +
                    static_cast<std::size_t>(strip)];
  }

  // Fills both layouts of a brick's planes, with the closed cells that border the grid.
  void load(int brick) {
    const int first = brick == 0 ? -1 : brick * strips::kPlanes;
    const int last = (brick + 1) * strips::kPlanes + (brick + 1 == layout_.bricks ? 1 : 0);
    const std::size_t begin = layout_.plane_vectors * static_cast<std::size_t>(first + 1) * MF_LANES;
    const std::size_t end = layout_.plane_vectors * static_cast<std::size_t>(last + 1) * MF_LANES;
    for (int side = 0; side < 2; ++side) {
      std::fill(costs_[side].get() + begin, costs_[side].get() + end, strips::kClosed);
      std::fill(steps_[side].get() + begin, steps_[side].get() + end, strips::kClosedStep);
    }
    for (int z = brick * strips::kPlanes; z < std::min(last, layout_.nz); ++z) {
      for (int y = 0; y < layout_.ny; ++y) {
        load_row(y, z);
      }
    }
  }

  void load_row(int y, int z) {
    const std::size_t row = grid_.index(0, y, z);
    const std::size_t straight = layout_.row_begin(y, z);
    const std::size_t mirrored = layout_.row_begin(mirror(y), z);
    for (int x = 0; x < layout_.nx; ++x) {
      const std::size_t cell = row + static_cast<std::size_t>(x);
      const std::size_t offset = static_cast<std::size_t>(x) * MF_LANES;
      const float s = slowness_[cell];
      if (!(s > 0.0F) || s == kUnreachedCost) {
        continue;
      }
      const bool source = cost_[cell] != kUnreachedCost;
      const float value = source ? cost_[cell] : strips::kFar;
      const float step = source ? strips::kClosedStep : s * grid_.cell;
      costs_[0][straight + offset] = value;
      costs_[1][mirrored + offset] = value;
      steps_[0][straight + offset] = step;
      steps_[1][mirrored + offset] = step;
      if (source) {
        mark_around(x, y, z);
      }
    }
  }

  bool open(std::size_t cell) const {
    return cost_[cell] == kUnreachedCost && slowness_[cell] > 0.0F && slowness_[cell] != kUnreachedCost;
  }

  // Sources amid sources or walls start nothing.
  bool borders_on_open(int x, int y, int z) const {
    const std::size_t cell = grid_.index(x, y, z);
    const auto row = static_cast<std::size_t>(layout_.nx);
    const std::size_t plane = row * static_cast<std::size_t>(layout_.ny);
    return (x > 0 && open(cell - 1)) || (x + 1 < layout_.nx && open(cell + 1)) ||
           (y > 0 && open(cell - row)) || (y + 1 < layout_.ny && open(cell + row)) ||
           (z > 0 && open(cell - plane)) || (z + 1 < layout_.nz && open(cell + plane));
  }

  void mark_around(int x, int y, int z) {
    if (!borders_on_open(x, y, z)) {
      return;
    }
    const Range range{std::max(x - 1, 0), std::min(x + 2, layout_.nx)};
    const int brick = z / strips::kPlanes;
    const int strip = y / strips::kRows;
    pending(brick, strip).own.add(range);
    if (y > 0) {
      pending(brick, (y - 1) / strips::kRows).own.add(range);
    }
    if (y + 1 < layout_.ny) {
      pending(brick, (y + 1) / strips::kRows).own.add(range);
    }
    if (z % strips::kPlanes == 0 && brick > 0) {
      pending(brick - 1, strip).from_above.add(range);
    }
    if (z % strips::kPlanes == strips::kPlanes - 1 && brick + 1 < layout_.bricks) {
      pending(brick + 1, strip).from_below.add(range);
    }
  }

  int mirror(int y) const { return layout_.strips * strips::kRows - 1 - y; }

  // Copies what changed in a brick to the other layout.
  void flip(int brick, bool flipped) {
    const float* from = costs_[flipped ? 1 : 0].get();
    float* to = costs_[flipped ? 0 : 1].get();
    for (int y = 0; y < layout_.ny; ++y) {
      const Range stale = pending(brick, y / strips::kRows).stale;
      for (int z = brick * strips::kPlanes; z < (brick + 1) * strips::kPlanes; ++z) {
        const std::size_t source = layout_.row_begin(flipped ? mirror(y) : y, z);
        const std::size_t target = layout_.row_begin(flipped ? y : mirror(y), z);
        for (int x = stale.begin; x < stale.end; ++x) {
          const std::size_t offset = static_cast<std::size_t>(x) * MF_LANES;
          to[target + offset] = from[source + offset];
        }
      }
    }
    for (int strip = 0; strip < layout_.strips; ++strip) {
      pending(brick, strip).stale = {};
    }
  }

  void store(int brick, bool flipped) {
    const float* from = costs_[flipped ? 1 : 0].get();
    const int last = std::min((brick + 1) * strips::kPlanes, layout_.nz);
    for (int z = brick * strips::kPlanes; z < last; ++z) {
      for (int y = 0; y < layout_.ny; ++y) {
        const float* row = from + layout_.row_begin(flipped ? mirror(y) : y, z);
        float* out = cost_.data() + grid_.index(0, y, z);
        for (int x = 0; x < layout_.nx; ++x) {
          const float value = row[static_cast<std::size_t>(x) * MF_LANES];
          out[x] = value < strips::kFar ? value : kUnreachedCost;
        }
      }
    }
  }

  // Sweeps this thread's bricks in one of the eight directions: towards +x and +y of the layout, or −x and
  // −y; towards +z or −z. A strip waits until the brick before has done the same strip, so that every cell
  // finds what it would find in a sweep by one thread. True if work is left for another sweep.
  bool run_sweep(unsigned thread, bool flipped, bool forward, bool upward) {
    bool left = false;
    std::uint64_t steps = 0;
    for (int turn = static_cast<int>(thread); turn < layout_.bricks; turn += static_cast<int>(threads_)) {
      const int brick = upward ? turn : layout_.bricks - 1 - turn;
      const int before = upward ? brick - 1 : brick + 1;
      for (int done = 0; done < layout_.strips; ++done) {
        if (turn > 0) {
          wait_for(counter(before), done);
        }
        const int strip = forward ? done : layout_.strips - 1 - done;
        left |= sweep_strip(brick, strip, flipped, forward, upward, steps);
        counter(brick).store(done + 1, std::memory_order_release);
      }
    }
    updates_ += steps * MF_LANES;
    return left;
  }

  static void wait_for(const std::atomic<int>& counter, int strip) {
    for (int spins = 0; counter.load(std::memory_order_acquire) <= strip; ++spins) {
      if (spins > 200) {
        std::this_thread::yield();
      }
    }
  }

  bool sweep_strip(int brick, int strip, bool flipped, bool forward, bool upward, std::uint64_t& steps) {
    // Pending work is kept by strips of the straight layout.
    const auto key = [&](int s) { return flipped ? layout_.strips - 1 - s : s; };
    Pending& here = pending(brick, key(strip));
    Range range = here.own;
    range.add(here.from_below);
    range.add(here.from_above);
    if (range.empty()) {
      return false;
    }
    here.own = here.from_below = here.from_above = {};
    strips::Brick place{};
    place.strip_stride = static_cast<std::ptrdiff_t>(layout_.row_vectors * MF_LANES);
    for (int i = 0; i < strips::kPlanes + 2; ++i) {
      const int z = brick * strips::kPlanes + (upward ? i - 1 : strips::kPlanes - i);
      place.plane[i] = layout_.strip_begin(strip, z);
    }
    float* cost = costs_[flipped ? 1 : 0].get();
    const float* step = steps_[flipped ? 1 : 0].get();
    const Outcome outcome = forward ? strips::sweep_brick<1>(cost, step, place, layout_, range)
                                    : strips::sweep_brick<-1>(cost, step, place, layout_, range);
    steps += outcome.steps;
    here.stale.add(outcome.changed);
    here.own.add(outcome.self);
    const int ahead = forward ? 1 : -1;
    const int above = upward ? 1 : -1;
    if (!outcome.y_back.empty()) {
      pending(brick, key(strip - ahead)).own.add(outcome.y_back);
    }
    if (!outcome.y_ahead.empty()) {
      pending(brick, key(strip + ahead)).own.add(outcome.y_ahead);
    }
    if (!outcome.z_back.empty()) {
      Pending& back = pending(brick - above, key(strip));
      (upward ? back.from_above : back.from_below).add(outcome.z_back);
    }
    if (!outcome.z_ahead.empty()) {
      Pending& next = pending(brick + above, key(strip));
      (upward ? next.from_below : next.from_above).add(outcome.z_ahead);
    }
    return !outcome.self.empty() || !outcome.y_back.empty() || !outcome.z_back.empty();
  }

  Grid grid_;
  Layout layout_;
  std::span<const float> slowness_;
  std::span<float> cost_;
  const std::function<void(int)>* progress_ = nullptr;
  unsigned threads_ = 1;
  Table costs_[2];  // straight, and with the y axis flipped
  Table steps_[2];
  std::vector<Pending> pending_;
  std::unique_ptr<Counter[]> done_;
  std::unique_ptr<std::barrier<>> barrier_;
  std::atomic<int> last_busy_{-1};
  std::atomic<std::uint64_t> updates_{0};
  int sweeps_ = 0;
};

EikonalSolver::EikonalSolver(const Grid& grid) : sweeper_(std::make_unique<Sweeper>(grid)) {}
EikonalSolver::EikonalSolver(EikonalSolver&&) noexcept = default;
EikonalSolver& EikonalSolver::operator=(EikonalSolver&&) noexcept = default;
EikonalSolver::~EikonalSolver() = default;

Result<EikonalStats> EikonalSolver::solve(std::span<const float> slowness, std::span<float> cost,
                                          unsigned threads, const std::function<void(int)>& progress) {
  if (auto good = check_input(sweeper_->grid(), slowness, cost); !good) {
    return fail(std::move(good.error()));
  }
  return sweeper_->run(slowness, cost, threads > 0 ? threads : std::thread::hardware_concurrency(), progress);
}

Result<EikonalStats> solve_eikonal(const Grid& grid, std::span<const float> slowness, std::span<float> cost,
                                   unsigned threads, const std::function<void(int)>& progress) {
  if (auto good = check_grid_of(grid); !good) {
    return fail(std::move(good.error()));
  }
  try {
    return EikonalSolver(grid).solve(slowness, cost, threads, progress);
  } catch (const std::bad_alloc&) {
    return fail(Cause::kEnvironment,
                "not enough memory for a cost field of " + std::to_string(grid.size()) + " cells");
  }
}

}  // namespace mayfly::fields
