// What: makes a failing set of points small enough to look at.
// Law:  the result still fails, and no single point can be left out of it.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "support/triangle.h"

namespace rbpa_test {

/// Removes ever smaller runs of points while `fails` stays true. Requires: fails(points).
/// Cost: a few n log n calls where few points matter, n² at worst.
Points shrink(Points points, const std::function<bool(const Points&)>& fails);

/// Returns the points as a C++ initializer whose literals read back to the same doubles.
std::string literal(std::span<const rbpa::Point> points);

/// Returns a double as a C++ expression that reads back to it.
std::string literal(double value);

}  // namespace rbpa_test
