// Robots whose poses were exchanged: two or more jumped at once, and each sits where another was expected.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "controller/estimator/source_judge.hpp"
#include "controller/estimator/told_motion.hpp"
#include "controller/estimator/track.hpp"

namespace mayfly::estimator {

// Of one source. A robot does not leap: where poses were exchanged it is the names that are wrong. So once
// all who take part stand still, each is given the name under which its poses go on; till then theirs are
// refused.
class IdSwaps {
 public:
  // Where more jumped at once than this, they were not exchanged: the frame moved.
  static constexpr std::size_t kMostAtOnce = 32;

  explicit IdSwaps(std::size_t robots);

  // The source's column in which a robot's samples stand.
  std::size_t column_of(std::size_t robot) const noexcept { return columns_[robot]; }

  // At the end of a tick. A jump counts for `window` from its stamp. True where an exchange was seen first.
  bool find(Time now, Time window, SourceJudge& judge, std::span<const Track> tracks) noexcept;
  // Whether an exchange is going on.
  bool any(const SourceJudge& judge) const noexcept;
  // True where all who take part stand, for this many samples and by their commands: they have been given
  // their columns, and are in begun().
  bool settle(int samples, SourceJudge& judge, const ToldMotion& told) noexcept;

  // Where a robot goes on after settle().
  struct Begun {
    std::size_t robot = 0;
    std::size_t column = 0;
    Sample sample;
  };
  std::span<const Begun> begun() const noexcept { return {begun_.data(), begun_count_}; }

 private:
  void gather(Time now, Time window, const SourceJudge& judge) noexcept;
  std::size_t owner_of(std::size_t robot, const SourceJudge& judge, const Track& track) const noexcept;
  void drop_broken_rings(SourceJudge& judge) const noexcept;
  bool mark_ring(std::size_t start, SourceJudge& judge) noexcept;

  std::vector<std::size_t> columns_;
  std::array<std::size_t, kMostAtOnce> jumped_{};  // robots
  std::array<std::size_t, kMostAtOnce> owners_{};  // indices in jumped_
  std::size_t jumped_count_ = 0;
  std::vector<Begun> begun_;
  std::size_t begun_count_ = 0;
};

}  // namespace mayfly::estimator
