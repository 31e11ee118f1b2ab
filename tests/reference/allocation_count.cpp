#include "tests/reference/allocation_count.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace mayfly {
namespace {

std::atomic<std::uint64_t> g_count{0};

}  // namespace

std::uint64_t allocation_count() noexcept {
  return g_count.load();
}

}  // namespace mayfly

// The sanitizers bring forms of their own for what is not replaced here: what is freed below must come from
// here.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++mayfly::g_count;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
