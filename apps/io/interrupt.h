// What: Ctrl-C, a polite kill and the end of the terminal as something the program notices between two steps, so that it can tidy up.
#pragma once

#include <functional>

namespace rbpa::app {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag, and a pipe closed by its reader, or a file as large as may
/// be, is an error of write().
void catch_interrupts();

/// While it lives its thread is interrupted as well once `go_on` is false: for a program that catches signals by itself.
class Interruption {
 public:
  explicit Interruption(std::function<bool()> go_on);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

 private:
  std::function<bool()> go_on_;
};

/// In any thread.
bool interrupted();

/// For a computation to ask whether to go on: false once a signal has come.
std::function<bool()> until_interrupted();

/// Throws Cancelled once a signal has come. Cost: two loads.
void stop_if_interrupted();

}  // namespace rbpa::app
