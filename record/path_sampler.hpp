// Paths for a picture, in bounded memory however long the flight and however large the swarm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "controller/flight/observer.hpp"

namespace mayfly::record {

// Keeps at most kMaxRows moments, evenly spaced in time, of at most kMaxPaths agents, evenly spread over the
// swarm. When the rows are full every second one is given up, and from then on half as many are taken.
class PathSampler final : public Observer {
 public:
  static constexpr std::size_t kMaxRows = 400;
  static constexpr std::size_t kMaxPaths = 2000;

  explicit PathSampler(std::size_t agents);

  void on_tick(const TickView& view) noexcept override;

  std::size_t paths() const noexcept { return paths_; }

  struct Row {
    double time_s = 0.0;
    std::span<const glm::vec3> positions;  // m, one a path; NaN where the agent is not there
  };
  // In order of time; the last tick is always there. Spans are valid until the next tick.
  std::vector<Row> rows() const;

 private:
  std::size_t agent_of(std::size_t path) const noexcept { return path * agents_ / paths_; }
  void store(std::size_t slot, const TickView& view) noexcept;
  void thin_out() noexcept;

  std::size_t agents_;
  std::size_t paths_;
  std::size_t latest_slot_ = kMaxRows;  // one slot beyond the rows is for the last tick
  std::vector<glm::vec3> positions_;    // slot by slot, paths_ each
  std::vector<double> times_;           // s, one a slot
  std::vector<std::size_t> order_;      // row → slot: thinning out moves these, never the positions
  std::vector<std::size_t> scratch_;
  std::size_t count_ = 0;
  std::uint64_t stride_ = 1;
  std::uint64_t seen_ = 0;
};

}  // namespace mayfly::record
