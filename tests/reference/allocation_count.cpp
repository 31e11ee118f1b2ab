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

void* operator new(std::size_t size) {
  ++mayfly::g_count;
  if (void* memory = std::malloc(size > 0 ? size : 1)) {
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
