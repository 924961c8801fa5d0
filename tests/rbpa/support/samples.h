// What: few random points at a time, of kinds that are hard to decide.
// Law:  a function of the kind and of the random numbers. Points may coincide.
#pragma once

#include <array>
#include <span>

#include "rbpa/base/point.h"
#include "support/random.h"

namespace rbpa_test {

enum class Kind {
  uniform,
  small_grid,        ///< integers from −3 to 3: most decisions are ties
  near_line,         ///< on a line except for a few units in the last place
  on_line,           ///< exactly on a line
  near_circle,       ///< on a circle except for a few units in the last place
  on_circle,         ///< integers at the same distance from an integer center
  offset_grid,       ///< spacing 10⁻³ at coordinates of 10⁶, rounded
  mixed_scales,      ///< every coordinate with an exponent of its own
  limits_of_double,  ///< from 2⁻¹⁵⁰ to just below 2¹⁵⁰, among them near ties
  extreme            ///< from the smallest to the largest double; not for Predicates<double>
};

inline constexpr std::array kinds_that_fit_double = {Kind::uniform,     Kind::small_grid,   Kind::near_line,
                                                     Kind::on_line,     Kind::near_circle,  Kind::on_circle,
                                                     Kind::offset_grid, Kind::mixed_scales, Kind::limits_of_double};

const char* name(Kind kind);

void fill(std::span<rbpa::Point> points, Kind kind, Random& random);

/// Returns `value` moved by up to `most` representable steps in either direction.
double jiggled(double value, int most, Random& random);

}  // namespace rbpa_test
