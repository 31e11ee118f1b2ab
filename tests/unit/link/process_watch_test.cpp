#include "controller/link/process_watch.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

namespace mayfly::link {
namespace {

// A child that waits to be killed.
pid_t start_child() {
  std::string program = "/bin/cat";
  std::array<char*, 2> arguments{program.data(), nullptr};
  std::array<int, 2> silence{};
  EXPECT_EQ(::pipe2(silence.data(), O_CLOEXEC), 0);  // its writing end stays open here
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, silence[0], STDIN_FILENO);
  pid_t child = -1;
  EXPECT_EQ(::posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), nullptr), 0);
  posix_spawn_file_actions_destroy(&actions);
  ::close(silence[0]);
  return child;
}

TEST(ProcessWatch, SeesAnEndThatWasViolent) {
  const pid_t child = start_child();
  const auto watch = ProcessWatch::of(child);
  ASSERT_TRUE(watch);
  EXPECT_FALSE(watch->has_ended());
  ::kill(child, SIGKILL);
  EXPECT_TRUE(watch->has_ended(std::chrono::minutes(1)));
  EXPECT_TRUE(watch->has_ended());
  // And after it was reaped, too.
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(watch->has_ended());
}

TEST(ProcessWatch, AStoppedProcessHasNotEnded) {
  const pid_t child = start_child();
  const auto watch = ProcessWatch::of(child);
  ASSERT_TRUE(watch);
  ::kill(child, SIGSTOP);
  ::waitpid(child, nullptr, WUNTRACED);
  EXPECT_FALSE(watch->has_ended());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

TEST(ProcessWatch, TakesADescriptorOver) {
  auto self = ProcessWatch::of(::getpid());
  ASSERT_TRUE(self);
  const auto adopted = ProcessWatch::adopt(::fcntl(self->descriptor(), F_DUPFD_CLOEXEC, 0));
  ASSERT_TRUE(adopted);
  EXPECT_FALSE(adopted->has_ended());
}

TEST(ProcessWatch, WhatIsNoProcessIsRefused) {
  EXPECT_FALSE(ProcessWatch::adopt(-1));
  const int null = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  EXPECT_FALSE(ProcessWatch::adopt(null));
  ::close(null);
}

}  // namespace
}  // namespace mayfly::link
