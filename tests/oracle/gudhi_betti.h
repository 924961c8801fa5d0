// What: the Betti numbers of tetrahedra with all their faces, as GUDHI computes them.
// How:  its simplex tree, and persistent cohomology with coefficients in Z/2, all simplices being there from the beginning.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rbpa_test {

/// Dimensions 0, 1 and 2. Requires: corners below 2^31.
std::array<std::size_t, 3> gudhi_betti(std::span<const std::array<std::uint32_t, 4>> tetrahedra);

}  // namespace rbpa_test
