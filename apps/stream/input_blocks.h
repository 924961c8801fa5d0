// What: the points of all files of the input, one file behind the other, read ahead of their consumer.
// Law:  the index of a point is its place in the whole input.
// Cost: a few blocks are in memory at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/point_file.h"
#include "stream/pass_progress.h"

namespace rbpa::app {

struct InputBlock {
  std::vector<Point> points = {};
  std::uint64_t first = 0;  ///< index of the first point
  std::size_t file = 0;     ///< of which they are
  bool ends_file = false;   ///< there are no points, and `about` is the file's own information
  PointFile about = {};
};

/// The beginning of a file of the input: what is before it.
struct InputPlace {
  std::size_t files = 0;
  std::uint64_t points = 0, bytes = 0;
};

/// Calls visit(block) with all blocks from a place on. Throws as read_points(), Cancelled.
void for_each_input_block(std::span<const PointSource> sources, const InputPlace& from, PassProgress& progress,
                          const std::function<void(const InputBlock&)>& visit);

}  // namespace rbpa::app
