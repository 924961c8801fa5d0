// What: finds the level of a triangle: the number of the first radius of a ladder that admits the triangle.
#pragma once

#include <algorithm>

#include "rbpa/base/point.h"
#include "rbpa/plane/hierarchy/ladder.h"
#include "rbpa/plane/hierarchy/rounded_circumradius.h"

namespace rbpa {

/// Returns the first level whose radius admits the triangle (a, b, c). `SomeLadder` is Ladder or ScaledLadder; the
/// corners are in the scale of `ladder`.
/// Requires: the last level admits the triangle.
template <typename Real, typename SomeLadder>
int first_level(const Point& a, const Point& b, const Point& c, const SomeLadder& ladder) {
  if (ladder.radius(0).template admits<Real>(a, b, c)) return 0;
  int level = std::clamp(ladder.first_reaching(circumradius<Real>(a, b, c)), 1, ladder.end());
  while (!ladder.is_last(level) && !ladder.radius(level).template admits<Real>(a, b, c)) ++level;
  return level;
}

}  // namespace rbpa
