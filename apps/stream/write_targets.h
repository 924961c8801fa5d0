// What: the last pass: triangles and polygons in order, into the requested files.
// Law:  the bytes of `rbpa mesh` and `rbpa shape`.
#pragma once

#include <cstdint>
#include <optional>

#include "io/bytes/output_file.h"
#include "io/crs.h"
#include "rbpa/base/point.h"
#include "stream/polygon_log.h"
#include "stream/request.h"
#include "stream/run_stream.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

/// Facts about all points.
struct PointsFacts {
  Point least = {}, greatest = {};
  std::optional<Crs> crs = std::nullopt;
  bool degrees = false;
};

/// Adds the targets to `outputs`, whole but for their names; those of single tiles are left out. The counts of the result
/// are given; the facts about polygons are filled in. Throws Failure, Cancelled.
void write_targets(const StreamRequest& request, const PointsFacts& facts, const TriangleRows& rows,
                   const PolygonLog& polygons, std::uint64_t sort_bytes, OutputSet& outputs, StreamResult& result);

}  // namespace rbpa::app
