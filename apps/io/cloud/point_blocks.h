// What: the points of a file, a block at a time.
// Law:  all blocks of a file together are what read_points() makes of it, point by point and in its order.
// Cost: that of reading the file once. Of raw numbers, .npy, LAS and text, packed by gzip or not, some megabytes are in
//       memory at a time; of all other formats the whole file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/point_file.h"

namespace rbpa::app {

class PointBlocks {
 public:
  PointBlocks() = default;
  virtual ~PointBlocks() = default;
  PointBlocks(const PointBlocks&) = delete;
  PointBlocks& operator=(const PointBlocks&) = delete;

  /// Replaces `block` by the next points, at least one; false at the end. Throws as read_points().
  virtual bool next(std::vector<Point>& block) = 0;
  /// How many bytes of the file were read so far.
  virtual std::uint64_t bytes_read() const = 0;
  /// What the file says about its points, which are not there: whole at the end.
  const PointFile& about() const { return about_; }

 protected:
  PointFile about_ = {};
};

/// Points in a block, about.
constexpr std::size_t points_in_block = 1U << 16U;

/// Requires a source whose path is not "-". Throws as read_points(), and BadInput where the path is no regular file: it
/// could not be read twice.
std::unique_ptr<PointBlocks> open_point_blocks(const PointSource& source);

}  // namespace rbpa::app
