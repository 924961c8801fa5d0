// What: what a run requires of its input.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// The shortest text that reads back to the number.
std::string text(double value);

/// OpenMesh numbers halfedges in int, and a triangulation of n points has fewer than 6n of them.
inline constexpr std::size_t max_points = std::numeric_limits<int>::max() / 6;
static_assert(max_points == 357'913'941);

/// Throws InvalidInput when there are more than `max_points`.
void check_number(std::size_t points);

/// Requires: 0 < alpha ≤ infinity; finite points, at most `max_points`. Throws InvalidInput that names the violated
///           requirement.
void check(std::span<const Point> points, double alpha);

/// Threads for a run on so many points: one for a few points, which are done before a second thread has started.
inline Threads threads_for(std::size_t points, unsigned wanted) { return Threads(points < 10'000 ? 1 : wanted); }

}  // namespace rbpa
