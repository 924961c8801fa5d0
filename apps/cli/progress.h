// What: how far a run of rbpa has come, said on a terminal.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "io/progress_line.h"
#include "rbpa/base/progress.h"

namespace rbpa::app {

/// "1.2 M triangles, 3.4 M/s, at most 2 s left" after `seconds`. There are at most two triangles a point. What is left is
/// said when there is something to judge by: after two seconds, and a hundredth of those triangles.
std::string progress_text(const Progress& progress, double seconds);
/// "1.2 M triangles".
std::string triangles_text(const Progress& progress, double seconds);

/// A line that counts triangles once there are some.
class TriangleProgress {
 public:
  using Text = std::function<std::string(const Progress& progress, double seconds)>;

  TriangleProgress(bool wanted, const std::string& doing, Text text)
      : text_(std::move(text)), line_("rbpa", wanted, doing) {}

  /// What the line says until there are triangles.
  void say(const std::string& text) {
    line_.say([text](double) { return text; });
  }

  /// For a run to call, one call at a time from any of its threads: takes note of how far it is, and says to stop after a
  /// signal. Must not outlive this.
  std::function<bool(const Progress&)> watch();

 private:
  std::atomic<std::size_t> triangles_ = 0, points_ = 0;
  bool begun_ = false;
  Text text_;
  ProgressLine line_;
};

}  // namespace rbpa::app
