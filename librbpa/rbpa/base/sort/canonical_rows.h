// What: brings rows of four numbers, such as tetrahedra, into lexicographic order.
// Law:  the order depends on the rows alone, not on the order in which they come or on threads.
// How:  rows are counted by their first number; the few rows of one first number are sorted by insertion. Each thread
//       has a range of first numbers, and scans all rows.
// Cost: linear if few rows have the same first number; faster if rows with the same first number are near each other in
//       memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"

namespace rbpa {

using Row = std::array<std::uint32_t, 4>;

/// Replaces `sorted` by the rows in order, and returns for each row its place in `sorted`.
/// Requires: the rows are distinct, and their first numbers are below `bound`; not checked.
meshops::FreshVector<std::uint32_t> sort_rows(std::span<const Row> rows, std::size_t bound, Threads& threads,
                                              std::vector<Row>& sorted);

}  // namespace rbpa
