// The program, started as a user starts it.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace mayfly::test {

struct Outcome {
  int exit_code = -1;  // 128 + the signal where one killed it
  std::string out, error;
};

// A running `mayfly`, its output in pipes. Wait for it before it goes out of scope.
class Process {
 public:
  // `environment` is added to this process's own, "NAME=value".
  explicit Process(const std::vector<std::string>& arguments,
                   const std::vector<std::string>& environment = {});
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  // Reads standard output until `text` has been written there; false at its end.
  bool read_until(const std::string& text);
  void send(int signal) const;
  pid_t id() const { return pid_; }
  Outcome wait();

 private:
  pid_t pid_ = -1;
  int out_ = -1;
  int error_ = -1;
  Outcome outcome_;
};

inline Outcome run_program(const std::vector<std::string>& arguments,
                           const std::vector<std::string>& environment = {}) {
  return Process(arguments, environment).wait();
}

}  // namespace mayfly::test
