// What: brings tetrahedra and their neighbors, found in any order, into the order that is promised of a Solid.
// Law:  the result depends on the set of tetrahedra alone.
// Cost: a sort of the rows, and a pass over the neighbors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/solid.h"

namespace rbpa::space {

/// Rows of a finder's numbers of points, positively oriented, and across from each corner the number of another row, or Solid::none.
struct SolidRows {
  std::vector<Row> corners;             ///< whose memory the solid's neighbors take over
  meshops::FreshVector<Row> neighbors;  ///< not looked at unless wanted
};

/// Throws InvalidInput where so many tetrahedra have more faces than 32 bits can number.
void check_number_of(std::size_t tetrahedra);

/// Fills in the simplices, and the neighbors if they are wanted. `index` has the input index of each number that is a corner, all below `bound`. Calls
/// `ask`, if any, between its steps; it may throw.
void fill_in(SolidRows rows, std::span<const std::uint32_t> index, std::size_t bound, bool neighbors, Threads& threads,
             const std::function<void()>& ask, Solid& solid);

}  // namespace rbpa::space
