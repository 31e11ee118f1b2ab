// How long a piece of work takes.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace mayfly::bench {

// s, the least of `repeats`: other programs on the machine come and go. The work is told which repeat it is.
double least_seconds(int repeats, const auto& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int n = 0; n < repeats; ++n) {
    const auto start = std::chrono::steady_clock::now();
    work(n);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

}  // namespace mayfly::bench
