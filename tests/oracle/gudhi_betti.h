// What: the Betti numbers of tetrahedra with all their faces, by GUDHI.
// How:  a simplex tree, and persistent cohomology with coefficients in Z/2, with all simplices present from the
//       beginning.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rbpa_test {

/// Returns the numbers of dimensions 0, 1 and 2. Requires: corners below 2^31.
std::array<std::size_t, 3> gudhi_betti(std::span<const std::array<std::uint32_t, 4>> tetrahedra);

}  // namespace rbpa_test
