// What: finds, by the hierarchy of a COPC file, the chunks of points that a box and a resolution need.
// Law:  the chunks are those of all nodes whose cube meets the box, down to the first level whose spacing is at most
//       the resolution.
// Cost: reads only pages of the hierarchy with such nodes; in memory are 64 KiB of a page, and 32 bytes for each chunk
//       and each page that is found.
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

/// Returns the nodes, ordered by `begin`. `info` is the data of the record "copc" 1, `scale` the size of the units of
/// coordinates. Throws BadInput that names the byte, for a hierarchy whose pages or keys cannot be right.
std::vector<LazNode> find_copc_nodes(const Content& content, std::string_view info, const std::array<double, 3>& scale,
                                     const PointWindow& window);

}  // namespace rbpa::app
