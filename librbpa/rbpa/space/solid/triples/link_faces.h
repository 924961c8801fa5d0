// What: links tetrahedra by their common faces.
// How:  a face belongs to its least corner. Rows are sorted by their first corners, so that most faces of a corner are
//       in the rows that begin with it; the faces across from a row's first corner are distributed by counting. The few
//       faces of each corner are sorted.
// Law:  the result does not depend on the number of threads.
// Cost: some ten nanoseconds for each face; 12 bytes for each tetrahedron in addition to the result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"

namespace rbpa::space {

/// Returns the neighbors of each row: neighbor k is the number of the other row that has the three corners other than
/// corner k, or 0xffffffff if there is none.
/// Requires: `rows` are sorted by first corner, each with its two least corners first; all corners are below `bound`;
///           no three corners are common to three rows.
meshops::FreshVector<std::array<std::uint32_t, 4>> link_faces(std::span<const std::array<std::uint32_t, 4>> rows,
                                                              std::size_t bound, Threads& threads);

}  // namespace rbpa::space
