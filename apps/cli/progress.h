// What: how far a run of rbpa has come, said on a terminal.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "io/progress_line.h"
#include "rbpa/rbpa.h"

namespace rbpa::app {

/// A line for a triangulation.
class TriangleProgress {
 public:
  explicit TriangleProgress(bool wanted) : line_("rbpa", wanted, "triangulating") {}

  /// For a run to call, one call at a time from any of its threads: takes note of how far it is, and says to stop after a
  /// signal. Must not outlive this.
  std::function<bool(const Progress&)> watch();

 private:
  std::atomic<std::size_t> triangles_ = 0, points_ = 0;
  bool begun_ = false;
  ProgressLine line_;
};

/// "1.2 M triangles, 3.4 M/s, at most 2 s left" after `seconds`. There are at most two triangles a point. What is left is
/// said when there is something to judge by: after two seconds, and a hundredth of those triangles.
std::string progress_text(const Progress& progress, double seconds);

}  // namespace rbpa::app
