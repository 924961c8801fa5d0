// What: reads the points of all input files, one file after another, in a thread that runs ahead of the caller.
// Law:  the index of a point is its position in the whole input, from 0.
// Cost: memory of a few blocks.
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
  std::vector<std::vector<double>> fields = {};  ///< as PointBlocks::fields()
  std::uint64_t first = 0;                       ///< index, in the whole input, of the first point of the block
  std::size_t file = 0;                          ///< number, from 0, of the file that contains `points`
  bool ends_file = false;  ///< true: the file ends, `points` is empty, and `about` has the facts about the file
  PointFile about = {};
};

/// The beginning of an input file, given by the numbers of files, points and bytes before it.
struct InputPlace {
  std::size_t files = 0;
  std::uint64_t points = 0, bytes = 0;
};

/// Calls visit(block) for all blocks from the place `from` on, in order, in the calling thread. Throws as read_points()
/// does, Cancelled, and what visit() throws.
void for_each_input_block(std::span<const PointSource> sources, const InputPlace& from, PassProgress& progress,
                          const std::function<void(const InputBlock&)>& visit);

}  // namespace rbpa::app
