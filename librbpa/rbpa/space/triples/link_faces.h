// What: the neighbors of tetrahedra, from their common faces.
// How:  a face belongs to its least corner. Rows come by their first corners, so that most faces of a corner are in the rows that begin with it;
//       those across from a row's first corner are distributed by counting. The few faces of a corner are sorted.
// Law:  does not depend on the number of threads.
// Cost: some ten nanoseconds a face; 12 bytes a tetrahedron beside the result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"

namespace rbpa::space {

/// Neighbor k of a row is the number of the other row with the three corners that are not corner k, or 0xffffffff.
/// Requires: rows by ascending first corners, each with its two least corners first; corners below `bound`; no three corners common to
///           three rows.
meshops::FreshVector<std::array<std::uint32_t, 4>> link_faces(std::span<const std::array<std::uint32_t, 4>> rows,
                                                              std::size_t bound, Threads& threads);

}  // namespace rbpa::space
