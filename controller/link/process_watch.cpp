#include "controller/link/process_watch.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>

extern "C" {  // which this header of glibc 2.36 forgets
#include <sys/pidfd.h>
}

namespace mayfly::link {
namespace {

std::string reason() {
  return std::generic_category().message(errno);
}

}  // namespace

Result<ProcessWatch> ProcessWatch::of(pid_t process) {
  const int descriptor = ::pidfd_open(process, 0);
  if (descriptor < 0) {
    return fail(Cause::kEnvironment, "a process cannot be watched: " + reason());
  }
  return ProcessWatch(descriptor);
}

Result<ProcessWatch> ProcessWatch::adopt(int descriptor) {
  // Signal 0 reaches nobody: it only asks whether there could be one.
  if (::pidfd_send_signal(descriptor, 0, nullptr, 0) != 0 && errno != ESRCH) {
    return fail(Cause::kEnvironment, "this descriptor is not one of a process: " + reason());
  }
  return ProcessWatch(descriptor);
}

ProcessWatch::~ProcessWatch() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

bool ProcessWatch::has_ended(Time most) const noexcept {
  constexpr Time kSecond{1'000'000'000};
  const timespec wait{static_cast<time_t>(most / kSecond), static_cast<long>((most % kSecond).count())};
  pollfd watched{descriptor_, POLLIN, 0};
  return ::ppoll(&watched, 1, &wait, nullptr) > 0;
}

}  // namespace mayfly::link
