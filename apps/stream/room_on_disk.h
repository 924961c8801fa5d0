// What: whether a disk has room for what is about to be written, as far as that can be determined.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "stream/scratch.h"

namespace rbpa::app {

/// The bytes per point in the files of tiles, estimated from some of them.
class PackedSample {
 public:
  void add(std::span<const Point> points, std::uint64_t first);
  double bytes_per_point() const;

 private:
  std::uint64_t blocks_ = 0, taken_ = 0, points_ = 0, bytes_ = 0;
};

/// Throws Failure saying how much is free and how much is needed, here as below.
void require_room_for_tiles(const Scratch& scratch, double points, const PackedSample& sample);

/// For the file at `path`, unless that is no file.
void require_room_for_output(const std::string& path, std::uint64_t bytes);

}  // namespace rbpa::app
