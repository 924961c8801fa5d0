// What: shows on a terminal how far a pass over the input or the tiles has come.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "io/progress_line.h"

namespace rbpa::app {

class PassProgress {
 public:
  /// `doing`: "2/4 cutting". All of it are `whole` units, of bytes or points.
  PassProgress(bool wanted, std::string doing, std::uint64_t whole);

  /// Done so far: of the whole, and in points. Of any thread.
  void at(std::uint64_t done, std::uint64_t points) {
    done_ = done;
    points_ = points;
  }

 private:
  std::string doing_;
  double whole_;
  std::atomic<std::uint64_t> done_ = 0, points_ = 0;
  ProgressLine line_;  // ends before what it looks at
};

}  // namespace rbpa::app
