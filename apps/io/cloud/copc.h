// What: finds in the hierarchy of a COPC file the chunks of points that a box and a resolution require.
// Law:  the chunks are those of all nodes whose cube meets the box, down to the first level whose spacing is at most
//       the resolution.
// Cost: reads only the pages of the hierarchy whose cube meets the box at a level that the law includes; in memory are
//       64 KiB of a page, and less than 100 bytes for each chunk and each page that is found.
// Source: COPC specification 1.0 (copc.io).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "io/bytes/content.h"
#include "io/cloud/point_window.h"
#include "io/laz/laz_records.h"

namespace rbpa::app {

/// Returns the nodes of the chunks, ordered by LazNode::begin. `info` is the data of the record "copc" 1, `scale` the
/// size of the units of coordinates. Throws BadInput that names the byte, for invalid pages or keys of the hierarchy.
std::vector<LazNode> find_copc_nodes(const Content& content, std::string_view info, const std::array<double, 3>& scale,
                                     const PointWindow& window);

}  // namespace rbpa::app
