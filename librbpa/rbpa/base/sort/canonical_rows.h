// What: brings rows of four numbers, such as tetrahedra, into lexicographic order.
// Law:  the order depends on the rows alone: not on the order in which they come, nor on threads.
// How:  buckets by the first number, each of which fits a cache; there by counting the first numbers, and the few rows of one by
//       insertion.
// Cost: linear where few rows have the same first number.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"

namespace rbpa {

using Row = std::array<std::uint32_t, 4>;

/// Sorts distinct rows, whose first numbers are below `bound`. Returns: of each row in order, where it was.
meshops::FreshVector<std::uint32_t> sort_rows(std::vector<Row>& rows, std::size_t bound, Threads& threads);

}  // namespace rbpa
