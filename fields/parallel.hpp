// A loop over independent pieces of work, for what is computed before the flight or beside it.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/progress.hpp"

namespace mayfly::fields {

// Some work that outlives the call it is given to; unlike std::function it never asks for memory.
class WorkReference {
 public:
  template <class Work>
  explicit WorkReference(const Work& work)
      : work_(&work), call_([](const void* w, std::size_t i) { (*static_cast<const Work*>(w))(i); }) {}

  void operator()(std::size_t i) const { call_(work_, i); }

 private:
  const void* work_;
  void (*call_)(const void*, std::size_t);
};

void parallel_for(std::size_t count, int threads, std::string_view stage, const Progress& progress,
                  const WorkReference& work);

// Calls work(i) once for each i in [0, count), on up to `threads` threads (< 1: all cores), in any order.
// Returns when all are done. `progress` is called from the calling thread, a few times a second. `work` must
// not throw.
template <class Work>
void parallel_for(std::size_t count, int threads, std::string_view stage, const Progress& progress,
                  const Work& work) {
  parallel_for(count, threads, stage, progress, WorkReference(work));
}

}  // namespace mayfly::fields
