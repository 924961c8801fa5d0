// What: records the levels of a hierarchy during a run, and calls the callback at the end of each.
// Law:  levels between the first and the last on which no triangle was added are left out.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>

#include "rbpa/plane/levels.h"
#include "rbpa/plane/predicate/radius.h"

namespace rbpa {

class LevelRecord {
 public:
  /// Keeps the span, and references to `ended` and `result`. The clock of the first level starts now.
  LevelRecord(double alpha, const std::function<void(const EndedLevel&)>& ended,
              std::span<const std::uint32_t> input_index, Hierarchy& result)
      : alpha_(alpha), ended_(ended), input_index_(input_index), result_(result) {}

  /// Records the end of a level. Requires: the mesh of the front is the complex of `radius`. Throws: any exception of
  /// `ended`.
  void end(Level level, const Radius& radius, bool is_last, const meshops::Front& front) {
    // The last level has the user's alpha: a radius beyond all circumradii is infinite to the run.
    level.alpha = is_last ? alpha_ : radius.value();
    level.triangles = front.faces();
    // A level without a triangle is left out, but its search may have visited sites, which depend on the order of the
    // input.
    if (!result_.levels.empty() && level.triangles == result_.levels.back().triangles && !is_last) {
      result_.looked_in_vain += level.taking_part;
      return;
    }
    level.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    result_.levels.push_back(level);
    if (ended_) ended_({result_.levels.back(), front, input_index_});
    start_ = Clock::now();
  }

 private:
  using Clock = std::chrono::steady_clock;

  double alpha_;
  const std::function<void(const EndedLevel&)>& ended_;
  std::span<const std::uint32_t> input_index_;
  Hierarchy& result_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace rbpa
