// What: checks alpha and points before a run, and chooses its number of threads.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// Returns the shortest text that reads back to `value`.
std::string text(double value);

/// Maximum number of points: a triangulation of n points has fewer than 6n halfedges, which OpenMesh numbers in int.
inline constexpr std::size_t max_points = std::numeric_limits<int>::max() / 6;
static_assert(max_points == 357'913'941);

/// Checks that there are at most `max_points` points. Throws: InvalidInput.
void check_number(std::size_t points);

/// Checks that 0 < alpha ≤ infinity and that the points are finite and at most `max_points`.
/// Throws: InvalidInput that names the violated requirement.
void check(std::span<const Point> points, double alpha);

/// Returns the threads for a run on a number of points: one for fewer than 10,000 points, as such a run ends before a
/// second thread has started; otherwise `wanted`.
inline Threads threads_for(std::size_t points, unsigned wanted) { return Threads(points < 10'000 ? 1 : wanted); }

}  // namespace rbpa
