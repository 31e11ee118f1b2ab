#include "tests/reference/tick_traps.hpp"

#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

#if defined(__x86_64__)
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#endif

#include "core/armed_tick.hpp"

namespace mayfly::test {
namespace {

std::atomic<std::uint64_t> g_allocations{0};
std::atomic<std::uint64_t> g_locks{0};
std::atomic<std::uint64_t> g_system_calls{0};
std::atomic<int> g_last_system_call{-1};

void note(std::atomic<std::uint64_t>& count) noexcept {
  if (ArmedTick::is_now()) {
    count.fetch_add(1, std::memory_order_relaxed);
    ArmedTick::report();
  }
}

// The function of that name that this program replaces.
template <class Function>
Function* next(const char* name) noexcept {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

TickOffences tick_offences() noexcept {
  return {g_allocations.load(), g_locks.load(), g_system_calls.load(), g_last_system_call.load()};
}

}  // namespace mayfly::test

// The C library's own, under the names that it keeps for replacements like these.
extern "C" {
// NOLINTBEGIN(readability-identifier-naming): the C library's names
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);
// NOLINTEND(readability-identifier-naming)

void* malloc(std::size_t size) {
  mayfly::test::note(mayfly::test::g_allocations);
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  mayfly::test::note(mayfly::test::g_allocations);
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  mayfly::test::note(mayfly::test::g_allocations);
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  mayfly::test::note(mayfly::test::g_allocations);
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) {
  mayfly::test::note(mayfly::test::g_allocations);
  __libc_free(memory);
}

// NOLINTBEGIN(cppcoreguidelines-macro-usage): a name and its forwarding cannot be written once otherwise.
#define MAYFLY_WATCHED_LOCK(name, parameters, arguments)               \
  int name parameters {                                                \
    using Function = int parameters;                                   \
    static Function* const real = mayfly::test::next<Function>(#name); \
    mayfly::test::note(mayfly::test::g_locks);                         \
    return real arguments;                                             \
  }
// NOLINTEND(cppcoreguidelines-macro-usage)
MAYFLY_WATCHED_LOCK(pthread_mutex_lock, (pthread_mutex_t * mutex), (mutex))
MAYFLY_WATCHED_LOCK(pthread_mutex_timedlock, (pthread_mutex_t * mutex, const timespec* until), (mutex, until))
MAYFLY_WATCHED_LOCK(pthread_rwlock_rdlock, (pthread_rwlock_t * lock), (lock))
MAYFLY_WATCHED_LOCK(pthread_rwlock_wrlock, (pthread_rwlock_t * lock), (lock))
MAYFLY_WATCHED_LOCK(pthread_cond_wait, (pthread_cond_t * condition, pthread_mutex_t* mutex),
                    (condition, mutex))
MAYFLY_WATCHED_LOCK(sem_wait, (sem_t * semaphore), (semaphore))
#undef MAYFLY_WATCHED_LOCK
}

#if defined(__x86_64__)

// A system call that the filter lets through, because of where it is made from.
asm(R"(
.text
.globl mayfly_free_system_call
.type mayfly_free_system_call, @function
mayfly_free_system_call:
  movq %rdi, %rax
  movq %rsi, %rdi
  movq %rdx, %rsi
  movq %rcx, %rdx
  movq %r8, %r10
  movq %r9, %r8
  movq 8(%rsp), %r9
  syscall
.globl mayfly_free_system_call_end
mayfly_free_system_call_end:
  ret
.size mayfly_free_system_call, .-mayfly_free_system_call
)");
extern "C" long mayfly_free_system_call(long number, long a, long b, long c, long d, long e, long f);
// NOLINTNEXTLINE(readability-identifier-naming): a label in the text above
extern "C" const char mayfly_free_system_call_end[];

namespace mayfly::test {
namespace {

// Counts the call where it is forbidden, then makes it, so that whoever asked goes on as without us.
void on_system_call(int, siginfo_t* info, void* context) {
  const int error = errno;
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  if (ArmedTick::is_now()) {
    g_last_system_call.store(info->si_syscall, std::memory_order_relaxed);
    note(g_system_calls);
  }
  registers[REG_RAX] =
      mayfly_free_system_call(info->si_syscall, registers[REG_RDI], registers[REG_RSI], registers[REG_RDX],
                              registers[REG_R10], registers[REG_R8], registers[REG_R9]);
  errno = error;
}

constexpr sock_filter load(std::size_t offset) {
  return {BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offset)};
}
constexpr sock_filter skip_if_equal(std::uint32_t value, std::uint8_t yes, std::uint8_t no) {
  return {BPF_JMP | BPF_JEQ | BPF_K, yes, no, value};
}
constexpr sock_filter answer(std::uint32_t action) {
  return {BPF_RET | BPF_K, 0, 0, action};
}

}  // namespace

bool trap_system_calls() noexcept {
  struct sigaction action {};
  action.sa_sigaction = on_system_call;
  action.sa_flags = SA_SIGINFO;
  if (sigaction(SIGSYS, &action, nullptr) != 0) {
    return false;
  }
  const auto from = reinterpret_cast<std::uint64_t>(mayfly_free_system_call_end);
  constexpr std::size_t kPointer = offsetof(seccomp_data, instruction_pointer);
  std::array<sock_filter, 10> filter{
      load(kPointer),
      skip_if_equal(static_cast<std::uint32_t>(from), 0, 2),
      load(kPointer + 4),
      skip_if_equal(static_cast<std::uint32_t>(from >> 32U), 5, 0),
      load(offsetof(seccomp_data, nr)),
      skip_if_equal(SYS_clock_gettime, 3, 0),
      skip_if_equal(SYS_clock_nanosleep, 2, 0),
      skip_if_equal(SYS_rt_sigreturn, 1, 0),
      answer(SECCOMP_RET_TRAP),
      answer(SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{filter.size(), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace mayfly::test

#else

namespace mayfly::test {

bool trap_system_calls() noexcept {
  return false;
}

}  // namespace mayfly::test

#endif
