// What: closed polylines on a mesh as a file.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/formats.h"

namespace rbpa::app {

/// Points one after the other, each once; the first follows the last.
using Polyline = std::vector<std::uint32_t>;

/// OBJ: all of `positions` as vertices, each loop as one element 'l', which names its first vertex again at the end.
/// JSON: a list of {"vertices": [numbers from 0], "positions": [[x, y, z], …]}.
void write_polylines(OutputFile& file, Format format, std::span<const std::array<double, 3>> positions,
                     std::span<const Polyline> loops);

}  // namespace rbpa::app
