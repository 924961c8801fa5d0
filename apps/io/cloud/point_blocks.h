// What: reads the points of a file in the plane, a block at a time.
// Law:  the blocks of a file, one after another, have the points of read_points() in their order.
// Cost: one pass over the file. Raw numbers, .npy, LAS and text, compressed by gzip or not, take some megabytes of
//       memory; files of all other formats are wholly in memory.
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

  /// Replaces the content of `block` by the next points, at least one; returns false at the end. Throws as
  /// read_points().
  virtual bool next(std::vector<Point>& block) = 0;
  /// Returns the columns that Condition::columns() of the source requests, with a value for each point of the block.
  const std::vector<std::vector<double>>& fields() const { return fields_; }
  /// Returns how many bytes of the file were read until now.
  virtual std::uint64_t bytes_read() const = 0;
  /// Returns the facts that the file states about its points, without the points; complete after the last block.
  const PointFile& about() const { return about_; }

 protected:
  PointFile about_ = {};
  std::vector<std::vector<double>> fields_ = {};
};

/// The approximate number of points in a block.
constexpr std::size_t points_in_block = 1U << 16U;

/// Opens a file. Requires: the path is not "-". Throws as read_points(), and BadInput unless the path is a regular
/// file, which can be read twice.
std::unique_ptr<PointBlocks> open_point_blocks(const PointSource& source);

}  // namespace rbpa::app
