// What: applies --min-hole-area and --min-part-area to the polygons of a run.
// Law:  polygons and numbers of points are those that `rbpa shape` writes with the same options.
// Cost: all corners are in memory, bytes_of_corner for each; the input is read once more to count points of polygons.
#pragma once

#include <cstdint>
#include <vector>

#include "io/polygon/shape_files.h"
#include "stream/polygon_log.h"
#include "stream/request.h"

namespace rbpa::app {

/// Peak memory for each corner of a polygon while polygons are filtered and points are located, in bytes.
constexpr std::uint64_t bytes_of_corner = 180;

class FilteredPolygons {
 public:
  /// Reads all polygons and applies request.filter. Throws Failure that names a sufficient --memory if `memory` bytes
  /// do not suffice for all corners; as PolygonLog::sorted().
  FilteredPolygons(const StreamRequest& request, const PolygonLog& log, std::uint64_t memory);

  /// Counts the points of the input in each polygon. `bytes` is the size of the input, for the progress. Throws as
  /// read_points(); Cancelled.
  void count_points(const StreamRequest& request, std::uint64_t bytes, std::uint64_t memory);

  /// Gives all polygons to `sink` in canonical order, and calls sink.finish().
  void show(PolygonSink& sink) const;

 private:
  std::vector<Point> corners_ = {};
  std::vector<Polygon> polygons_ = {};
  std::vector<std::uint64_t> points_ = {};  // number of points of each polygon
};

}  // namespace rbpa::app
