// What: shows the progress of a run of rbpa on a terminal.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "io/progress_line.h"
#include "rbpa/base/progress.h"

namespace rbpa::app {

/// Returns a text such as "1.20 M triangles, 3.40 M/s, at most 2 s left" after `seconds`. The time left is an upper
/// bound, as there are at most two triangles for each point. It is shown from two seconds on, if at least a hundredth
/// of this number of triangles is found.
std::string progress_text(const Progress& progress, double seconds);
/// Returns a text such as "1.20 M triangles".
std::string triangles_text(const Progress& progress, double seconds);

/// A progress line that counts triangles once there are triangles.
class TriangleProgress {
 public:
  using Text = std::function<std::string(const Progress& progress, double seconds)>;

  TriangleProgress(bool wanted, const std::string& doing, Text text)
      : text_(std::move(text)), line_("rbpa", wanted, doing) {}

  /// Shows `text` until there are triangles.
  void say(const std::string& text) {
    line_.say([text](double) { return text; });
  }

  /// Returns a function that records the progress, and returns false after a signal. Any thread may call the function,
  /// but not two threads at the same time. The function must not outlive this object.
  std::function<bool(const Progress&)> watch();

 private:
  std::atomic<std::size_t> triangles_ = 0, points_ = 0;
  bool begun_ = false;
  Text text_;
  ProgressLine line_;
};

}  // namespace rbpa::app
