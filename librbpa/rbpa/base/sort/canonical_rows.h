// What: brings rows of four numbers, such as tetrahedra, into lexicographic order.
// Law:  the order depends on the rows alone, not on the order in which they come or on threads.
// How:  rows are counted by their first number; then the rows of each first number are sorted: up to 24 by insertion,
//       more by std::sort(). Each thread has a range of first numbers, and scans all rows.
// Cost: linear if few rows share each first number; faster if these rows are near each other in memory.
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

/// Gives `rows` a number of rows without a content. All threads share the first touch of the memory, which takes longer
/// than the zeros that are written later.
void resize_rows(std::vector<Row>& rows, std::size_t count, Threads& threads);

/// Replaces the content of `sorted` by the rows in order. Returns for each row its position in `sorted`.
/// Requires: the rows are distinct, and their first numbers are below `bound`; not checked.
meshops::FreshVector<std::uint32_t> sort_rows(std::span<const Row> rows, std::size_t bound, Threads& threads,
                                              std::vector<Row>& sorted);

}  // namespace rbpa
