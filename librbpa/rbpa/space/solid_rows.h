// What: brings tetrahedra and their neighbours, found in any order, into the order that is promised of a Solid.
// Law:  the result depends on the set of tetrahedra alone.
// Cost: a sort of the rows, and a pass over the neighbours.
#pragma once

#include <cstddef>
#include <functional>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/solid.h"

namespace rbpa::space {

/// Rows of input indices, positively oriented, and across from each corner the number of another row, or Solid::none.
struct SolidRows {
  meshops::FreshVector<Row> corners;
  meshops::FreshVector<Row> neighbors;  ///< not looked at unless wanted
};

/// Fills in the simplices, and the neighbours if they are wanted. `bound` is above all indices. Calls `ask`, if any, between its steps; it may
/// throw.
void fill_in(SolidRows rows, std::size_t bound, bool neighbors, Threads& threads, const std::function<void()>& ask,
             Solid& solid);

/// The same corners, the two least first, by an even permutation.
Row two_least_first(const Row& corners);

}  // namespace rbpa::space
