// What: what a run requires of its input, and the arithmetic that suits it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "rbpa/core/point.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/predicate/magnitude.h"
#include "rbpa/predicate/radius.h"

namespace rbpa {

/// The shortest text that reads back to the number.
std::string text(double value);

/// OpenMesh numbers halfedges in int, and a triangulation of n points has fewer than 6n of them.
inline constexpr std::size_t most_points = std::numeric_limits<int>::max() / 6;
static_assert(most_points == 357'913'941);

/// Throws InvalidInput when there are more than `most_points`.
void check_number(std::size_t points);

/// Requires: 0 < alpha ≤ infinity; finite points, at most `most_points`. Throws InvalidInput naming what is not.
void check(std::span<const Point> points, double alpha);

/// Threads for a run on so many points: few are done before another thread has woken.
inline Threads threads_for(std::size_t points, unsigned wanted) { return Threads(points < 10'000 ? 1 : wanted); }

/// Calls run(radius, grid_unit, below_all) with numbers of the arithmetic for which the input's products stay in range.
/// `grid_unit` is as Candidates wants it. No circumradius is below `below_all`.
template <typename Run>
auto with_arithmetic_for(std::span<const Point> points, double alpha, Run run) {
  const Magnitude span = magnitude(points);
  if (!fits_double(span)) return run(std::isinf(alpha) ? Radius() : Radius(alpha), 0.0L, 0.0);
  const RadiusBounds bounds = radius_bounds(span);
  const double below_all = std::ldexp(1.0, bounds.below_all);
  const Radius radius = alpha > std::ldexp(1.0, bounds.above_all) ? Radius() : Radius(std::max(alpha, below_all));
  return run(radius, std::ldexp(1.0, span.lowest), below_all);
}

}  // namespace rbpa
