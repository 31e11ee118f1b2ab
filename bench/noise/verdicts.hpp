// Does curl noise win where Wang14 §7.1 says that it does?
#pragma once

#include <span>
#include <vector>

#include "bench/noise/comparison.hpp"

namespace mayfly::bench {

// One claim after the other. Each bound lies well between what the two sides of it measure.
std::vector<Verdict> judge(std::span<const VariantResult> variants);

}  // namespace mayfly::bench
