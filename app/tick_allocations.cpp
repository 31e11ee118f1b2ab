// Every allocation by which a control tick breaks its promise is counted: core/armed_tick.hpp. It costs the
// others one look at a number of the thread's own.
#include <cstddef>
#include <cstdlib>
#include <new>

#include "core/armed_tick.hpp"

namespace {

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  if (mayfly::ArmedTick::is_now()) {
    mayfly::ArmedTick::report();
  }
  const std::size_t wanted = size > 0 ? size : 1;
  if (alignment <= alignof(std::max_align_t)) {
    return std::malloc(wanted);
  }
  return std::aligned_alloc(alignment, (wanted + alignment - 1) / alignment * alignment);
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  if (void* memory = allocate(size, alignment)) {
    return memory;
  }
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate_or_throw(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
