// What: shows on a terminal the progress of a pass over the input or the tiles.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "io/progress_line.h"

namespace rbpa::app {

class PassProgress {
 public:
  /// Shows `doing`, such as "2/4 cutting", if `wanted` is true and standard error is a terminal. `whole` is the size of
  /// the pass, in bytes or in points.
  PassProgress(bool wanted, std::string doing, std::uint64_t whole);

  /// Sets the finished part of the pass: `done` in the unit of `whole`, and a number of points. Safe for any thread.
  void at(std::uint64_t done, std::uint64_t points) {
    done_ = done;
    points_ = points;
  }

 private:
  std::string doing_;
  double whole_;
  std::atomic<std::uint64_t> done_ = 0, points_ = 0;
  ProgressLine line_;  // last member, so that it is destroyed before the values that it reads
};

}  // namespace rbpa::app
