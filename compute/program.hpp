// Kernels, built from the embedded sources and kept on disk as the device's own binary.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "compute/buffer.hpp"
#include "compute/device.hpp"

namespace mayfly::compute {

// One kernel with its arguments. Not for two threads at once.
class Kernel {
 public:
  // All arguments in order: a Buffer for a pointer, a plain struct or number by value. They stay set until
  // set again.
  template <class... Arguments>
  Status set(const Arguments&... arguments) noexcept {
    unsigned index = 0;
    Status status;
    static_cast<void>(((status = set_one(index++, arguments)).ok() && ...));
    return status;
  }
  // Runs once for each of `items`, which must be a multiple of `group`; a fixed group spares the runtime a
  // compilation for each new size. Returns before it has run. Nothing to do, and success, for 0 items.
  Status enqueue(std::size_t items, std::size_t group) noexcept;

 private:
  friend class Program;
  struct State;
  struct Deleter {
    void operator()(State* state) const noexcept;
  };
  explicit Kernel(State* state) : state_(state) {}

  Status set_raw(unsigned index, std::size_t size, const void* value) noexcept;
  template <class T>
  Status set_one(unsigned index, const Buffer<T>& buffer) noexcept {
    return set_raw(index, sizeof(void*), buffer.raw().argument());
  }
  template <class T>
  Status set_one(unsigned index, const T& value) noexcept {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    return set_raw(index, sizeof value, &value);
  }

  std::unique_ptr<State, Deleter> state_;
};

// How programs came to be since the process started. Every cache failure means: compile.
struct ProgramCounters {
  std::uint64_t compiled = 0;
  std::uint64_t from_cache = 0;
  std::uint64_t rejected = 0;  // cached files that were truncated, garbled, or refused by the device
  std::uint64_t unstored = 0;  // binaries that could not be written
};
ProgramCounters program_counters() noexcept;

class Program {
 public:
  // Builds kernels/`name`.cl (see sources.hpp), e.g. "plants". `options` are added to those that every
  // program gets.
  static Result<Program> build(const Device& device, std::string_view name, std::string_view options = {});
  // The same from text; `name` is only for messages. A failure carries the compiler's log.
  static Result<Program> build_source(const Device& device, std::string_view name, std::string_view source,
                                      std::string_view options = {});

  Result<Kernel> kernel(const std::string& name) const;
  bool from_cache() const noexcept;

 private:
  struct State;
  explicit Program(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

}  // namespace mayfly::compute
