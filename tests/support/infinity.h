// What: the radius of all triangles and tetrahedra.
#pragma once

#include <limits>

namespace rbpa_test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace rbpa_test
