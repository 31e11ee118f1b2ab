#include "app/signals.hpp"

#include <atomic>
#include <csignal>

namespace mayfly::app {
namespace {

// A signal handler reaches nothing but globals.
StopRequest stop_request{0};
std::atomic<int> last_signal{0};
static_assert(StopRequest::is_always_lock_free, "a signal handler may set it");

constexpr int kSignals[] = {SIGINT, SIGTERM};

extern "C" void on_stop_signal(int number) {
  last_signal.store(number, std::memory_order_relaxed);
  if (stop_request.fetch_add(1, std::memory_order_relaxed) + 1 >= 3) {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
}

extern "C" void on_stop_signal_of_guard(int number) {
  last_signal.store(number, std::memory_order_relaxed);
  stop_request.fetch_add(1, std::memory_order_relaxed);
}

void set_handlers(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int number : kSignals) {
    sigaction(number, &action, nullptr);
  }
}

}  // namespace

StopSignals::StopSignals(Of of) {
  stop_request.store(0);
  last_signal.store(0);
  set_handlers(of == Of::kGuard ? on_stop_signal_of_guard : on_stop_signal);
  if (of == Of::kGuard) {
    std::signal(SIGHUP, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
  }
}

StopSignals::~StopSignals() {
  set_handlers(SIG_DFL);
}

const StopRequest& StopSignals::stop() const noexcept {
  return stop_request;
}
int StopSignals::signal_number() const noexcept {
  return last_signal.load();
}

}  // namespace mayfly::app
