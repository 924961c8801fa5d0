// What: the ways in which triangles are found, all with the same result.
#pragma once

namespace rbpa {

enum class Search {
  near_to_far,  ///< in tiles; grids whose cells follow the points, searched outward and bounded by the candidate's circle
  paper         ///< as the paper says it: cells of side 2α, nine of them scanned each time; cost grows with α²
};

}  // namespace rbpa
