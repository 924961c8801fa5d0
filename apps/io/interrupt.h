// What: stops a run between two steps after Ctrl-C (SIGINT), SIGTERM or SIGHUP, so that the run can clean up.
#pragma once

#include <cstddef>
#include <functional>

#include "rbpa/base/progress.h"

namespace rbpa::app {

/// Installs handlers. From then on SIGINT and SIGTERM, and SIGHUP unless it was ignored, only set a flag; and write()
/// fails for a pipe closed by its reader and for a file at its greatest permitted size.
void catch_interrupts();

/// A reason to stop beside signals, for programs that catch signals themselves: while the object exists, interrupted()
/// is also true in its thread whenever go_on() returns false. Requires: no other Interruption in this thread.
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

/// A counter of the steps of loops: calls interrupted() once in about 16384 steps, and throws Cancelled if it is true.
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
