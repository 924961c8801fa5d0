// What: shows on a terminal how far a run of rbpa is.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "io/progress_line.h"
#include "rbpa/base/progress.h"

namespace rbpa::app {

/// Returns "1.20 M triangles, 3.40 M/s, at most 2 s left" after `seconds`. The time left is a bound, as there are at
/// most two triangles for each point; it is shown after two seconds, if at least a hundredth of so many triangles is
/// found.
std::string progress_text(const Progress& progress, double seconds);
/// Returns "1.20 M triangles".
std::string triangles_text(const Progress& progress, double seconds);

/// A progress line that counts triangles as soon as there are some.
class TriangleProgress {
 public:
  using Text = std::function<std::string(const Progress& progress, double seconds)>;

  TriangleProgress(bool wanted, const std::string& doing, Text text)
      : text_(std::move(text)), line_("rbpa", wanted, doing) {}

  /// Shows `text` until there are triangles.
  void say(const std::string& text) {
    line_.say([text](double) { return text; });
  }

  /// Returns a function that records the progress, and returns false after a signal. It may be called from any thread,
  /// but only once at a time, and must not outlive this object.
  std::function<bool(const Progress&)> watch();

 private:
  std::atomic<std::size_t> triangles_ = 0, points_ = 0;
  bool begun_ = false;
  Text text_;
  ProgressLine line_;
};

}  // namespace rbpa::app
