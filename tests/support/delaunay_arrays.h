// What: the Delaunay triangulation, as the input of filtrations.
#pragma once

#include <limits>
#include <span>

#include "rbpa/plane/alpha_complex.h"

namespace rbpa_test {

inline rbpa::AlphaComplex delaunay_arrays(std::span<const rbpa::Point> points) {
  return rbpa::alpha_complex(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
}

}  // namespace rbpa_test
