// What: generates sets of balls that reach every kind of decision about weights.
// Law:  a set is a function of its arguments alone, down to the last bit.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "support/random.h"
#include "support/space_sets.h"

namespace rbpa_test {

struct Balls {
  Points3 centers;
  std::vector<double> radii;
};

enum class RadiusKind {
  equal,
  alternating,  ///< 1 or 2 by the parity of a grid, else by chance: ties on grids, nested and tangent balls
  integers,     ///< 0 to 4
  along_x,      ///< |x|, so that lifts are y² + z²: centers on a line along x have lifts on a line
  norm,         ///< |center|, exact on axes: lifts of about 0
  near_tie,     ///< |x| or |center|, and some moved by a last bit
  spacing,      ///< any, up to the spacing
  decades,      ///< from 1e-6 to 1e3 spacings
};
inline constexpr int radius_kinds = static_cast<int>(RadiusKind::decades) + 1;

std::string name(RadiusKind kind);

/// Returns about `count` balls. Some have the center of another.
Balls ball_set(SpaceKind centers, RadiusKind radii, std::size_t count, Random& random);

/// Returns a text for people: the balls as doubles that read back.
std::string text(const Balls& balls);

}  // namespace rbpa_test
