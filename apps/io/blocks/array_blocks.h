// What: points of files that hold numbers at regular distances, a block at a time: raw pairs, .npy, LAS.
#pragma once

#include <memory>

#include "io/blocks/point_blocks.h"

namespace rbpa::app {

std::unique_ptr<PointBlocks> open_raw_blocks(const PointSource& source);
std::unique_ptr<PointBlocks> open_npy_blocks(const PointSource& source);
std::unique_ptr<PointBlocks> open_las_blocks(const PointSource& source);

}  // namespace rbpa::app
