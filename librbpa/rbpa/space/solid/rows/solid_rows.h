// What: sorts tetrahedra and their neighbors, found in any order, into the canonical order of a Solid.
// Law:  the result depends on the set of tetrahedra alone.
// Cost: a sort of the rows, and a pass over the neighbors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Tetrahedra whose corners are the numbers of points in a search, not input indices. Row t of `corners` has the
/// corners of tetrahedron t, positively oriented. Row t of `neighbors` has the tetrahedron across from each corner, or
/// Solid::none.
struct SolidRows {
  std::vector<Row> corners;             ///< the memory is reused for Solid::neighbors
  meshops::FreshVector<Row> neighbors;  ///< used only if neighbors are wanted
};

/// Throws InvalidInput for more than 2^30 tetrahedra, whose faces 32 bits could not number.
void check_number_of(std::size_t tetrahedra);

/// Fills in the simplices of `solid`, and the neighbors if `neighbors` is true. `index` has the input index of each
/// number in rows.corners, below `bound`. Calls `checkpoint`, if any, between its steps; `checkpoint` may throw.
void fill_in(SolidRows rows, std::span<const std::uint32_t> index, std::size_t bound, bool neighbors, Threads& threads,
             const Checkpoint& checkpoint, Solid& solid);

}  // namespace rbpa::space
