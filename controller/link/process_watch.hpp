// Whether another process still lives: by a descriptor of it, which no later process can inherit the number
// of.
#pragma once

#include <sys/types.h>

#include <utility>

#include "core/clock.hpp"
#include "core/result.hpp"

namespace mayfly::link {

// A pidfd. May be looked at from any thread.
class ProcessWatch {
 public:
  // Of a process that cannot have been reaped yet: this one, or a child of it.
  static Result<ProcessWatch> of(pid_t process);
  // Takes a descriptor over that was handed down; fails where it is not one of a process.
  static Result<ProcessWatch> adopt(int descriptor);

  ProcessWatch(ProcessWatch&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  ProcessWatch& operator=(ProcessWatch&&) = delete;
  ProcessWatch(const ProcessWatch&) = delete;
  ProcessWatch& operator=(const ProcessWatch&) = delete;
  ~ProcessWatch();

  int descriptor() const noexcept { return descriptor_; }
  // Waits for its end, so long at most; blocks, unless `most` is 0. True once it has ended, however that was.
  bool has_ended(Time most = Time(0)) const noexcept;

 private:
  explicit ProcessWatch(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace mayfly::link
