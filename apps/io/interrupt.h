// What: stops a run between two steps after Ctrl-C (SIGINT), SIGTERM or SIGHUP, so that the run can clean up.
#pragma once

#include <cstddef>
#include <functional>

#include "rbpa/base/progress.h"

namespace rbpa::app {

/// Installs handlers: from then on SIGINT, SIGTERM and SIGHUP (unless it is ignored) only set a flag, and write() fails
/// for a pipe closed by its reader and for a file at its greatest permitted size.
void catch_interrupts();

/// While it exists, interrupted() is also true in the thread that made it whenever go_on() returns false. For programs
/// that catch signals themselves. Requires: no other Interruption in this thread.
class Interruption {
 public:
  explicit Interruption(std::function<bool()> go_on);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

 private:
  std::function<bool()> go_on_;
};

/// Returns whether a signal has arrived, or go_on() of an Interruption of this thread returns false. Any thread may
/// call it.
bool interrupted();

/// Returns a progress function for computations, which returns !interrupted().
std::function<bool()> until_interrupted();

/// Throws Cancelled if interrupted(). Cost: two loads without an Interruption.
void stop_if_interrupted();

/// Counter of the steps of loops, as meshops::Steps: throws Cancelled if interrupted() after 16384 more steps.
class InterruptibleSteps {
 public:
  InterruptibleSteps() = default;
  InterruptibleSteps(const InterruptibleSteps&) = delete;
  InterruptibleSteps& operator=(const InterruptibleSteps&) = delete;

  void operator()(std::size_t steps = 1) { steps_(steps); }

 private:
  GoOn go_on_ = until_interrupted();
  meshops::Steps steps_{go_on_};
};

}  // namespace rbpa::app
