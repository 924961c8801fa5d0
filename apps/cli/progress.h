// What: how far a run has come, said on a terminal.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "rbpa/rbpa.h"

namespace rbpa::app {

/// One line on standard error, rewritten a few times a second, and gone with this object.
class ProgressLine {
 public:
  /// Silent unless `wanted` and standard error is a terminal.
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// For a run to call, one call at a time from any of its threads: shows how far it is, and says to stop after a
  /// signal. Must not outlive this line.
  std::function<bool(const Progress&)> watch();
  /// The same for what tells no numbers: "doing, 3 s".
  std::function<bool()> watch(std::string doing);

 private:
  /// text(seconds), not too often.
  template <typename Text>
  void show(const Text& text);

  using Clock = std::chrono::steady_clock;

  bool shown_;
  bool written_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
};

/// "1.2 M triangles, 3.4 M/s, at most 2 s left" after `seconds`. There are at most two triangles a point.
std::string progress_text(const Progress& progress, double seconds);

}  // namespace rbpa::app
