// What: the targets of speed, as ratios of medians that were measured in turn, and the measured ratios.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/measure.h"

namespace rbpa_bench {

enum class Sense { at_least, at_most };

struct Target {
  std::string what;
  Sense sense;
  double bound;
  std::optional<double> measured;  ///< absent if the contest was not held, or one of the two failed or was wrong
};

inline bool is_met(const Target& target) {
  return target.measured &&
         (target.sense == Sense::at_least ? *target.measured >= target.bound : *target.measured <= target.bound);
}

/// Measured contests, by kind.
struct Measured {
  std::vector<Contest> delaunay;  ///< without a radius
  std::vector<Contest> alpha;     ///< with a radius
  std::vector<Contest> traps;
  std::vector<Contest> sweep;  ///< the same points with several alphas
};

/// Returns all targets for one thread and two. `points` is the number of points of the large contests; others have a
/// tenth of it or sixteen times as many.
std::vector<Target> targets(const Measured& measured, std::size_t points);

}  // namespace rbpa_bench
