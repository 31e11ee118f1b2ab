// Lets a test see that code asks for no memory: link tests/reference/allocation_count.cpp, which replaces
// operator new.
#pragma once

#include <cstdint>

namespace mayfly {

// How often anything in this program called operator new so far.
std::uint64_t allocation_count() noexcept;

}  // namespace mayfly
