// What: compares a circumradius with alpha, as the oracles trust it.
// How:  compares |ab|²|bc|²|ca|² with 4 alpha² (ab × ac)², by intervals with directed rounding if they decide,
//       otherwise by rational numbers, which have neither overflow nor underflow.
#pragma once

#include "rbpa/base/point.h"

namespace rbpa_test {

/// Returns whether the circumradius of (a, b, c) is at most alpha, by the exact square of alpha. True if alpha is
/// infinite.
/// Requires: a, b, c are not on a line.
bool circumradius_at_most(const rbpa::Point& a, const rbpa::Point& b, const rbpa::Point& c, double alpha);

/// Compares by rational numbers alone.
bool circumradius_at_most_exactly(const rbpa::Point& a, const rbpa::Point& b, const rbpa::Point& c, double alpha);

}  // namespace rbpa_test
