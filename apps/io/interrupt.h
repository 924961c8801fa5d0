// What: stops a run between two steps after Ctrl-C (SIGINT), SIGTERM or SIGHUP, so that it can clean up.
#pragma once

#include <functional>

namespace rbpa::app {

/// Installs handlers: SIGINT, SIGTERM and SIGHUP only set a flag from then on; a pipe closed by its reader, or a file
/// at its greatest permitted size, becomes an error of write().
void catch_interrupts();

/// Interrupts its own thread as well while it exists, once go_on() returns false. For programs that catch signals
/// themselves.
class Interruption {
 public:
  explicit Interruption(std::function<bool()> go_on);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

 private:
  std::function<bool()> go_on_;
};

/// Returns whether a signal has arrived. Callable from any thread.
bool interrupted();

/// Returns a progress function for computations: it returns false after a signal has arrived.
std::function<bool()> until_interrupted();

/// Throws Cancelled if a signal has arrived. Cost: two loads.
void stop_if_interrupted();

}  // namespace rbpa::app
