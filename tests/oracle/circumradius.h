// What: the comparison of a circumradius with alpha that the oracles trust.
// How:  |ab|²|bc|²|ca|² against 4 alpha² (ab × ac)², by intervals with directed rounding where they decide, else by
//       rational numbers, which have neither overflow nor underflow.
#pragma once

#include "rbpa/base/point.h"

namespace rbpa_test {

/// Is the circumradius of (a, b, c) at most alpha? alpha² is the exact square of the double; true for infinity.
/// Requires: a, b, c are not on a line.
bool circumradius_at_most(const rbpa::Point& a, const rbpa::Point& b, const rbpa::Point& c, double alpha);

/// The same by rational numbers alone.
bool circumradius_at_most_exactly(const rbpa::Point& a, const rbpa::Point& b, const rbpa::Point& c, double alpha);

}  // namespace rbpa_test
