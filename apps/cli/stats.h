// What: the report that --stats writes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "io/bytes/output_file.h"
#include "rbpa/shape.h"
#include "rbpa/topology.h"

namespace rbpa::app {

/// Of polygons that were filled.
struct FillStats {
  std::size_t on_boundary = 0;  ///< points that were put on edges
  std::size_t inside = 0;       ///< points that were put inside
  std::size_t retreats = 0;     ///< of the front
  std::size_t features = 0;     ///< of the file
  std::size_t left_out = 0;     ///< of these, as they are not valid
};

/// Of groups of points.
struct GroupStats {
  std::size_t groups = 0;
  std::size_t without_polygon = 0;
  std::size_t triangles = 0;  ///< of all of them
};

struct Stats {
  std::size_t points = 0;
  std::size_t distinct = 0;
  unsigned threads = 1;  ///< that may have worked
  /// What a verb does not compute is null in the report.
  std::optional<double> alpha = std::nullopt;
  std::optional<std::string> alpha_rule = std::nullopt;
  std::optional<std::size_t> isolated = std::nullopt;
  std::optional<ComplexCounts> counts = std::nullopt;
  std::string method = "rbpa";                               ///< where there are counts
  std::optional<std::size_t> dangling_edges = std::nullopt;  ///< key only where the complex is a full one
  /// Keys for polygons are in the report only where a verb makes them.
  std::optional<std::size_t> polygons = std::nullopt;
  PolygonTotals of_polygons = {};
  std::optional<GroupStats> groups = std::nullopt;  ///< keys only of groups; what is of one complex is null then
  std::optional<FillStats> fill = std::nullopt;     ///< keys only of `rbpa fill`
  std::optional<std::size_t> tiles = std::nullopt;  ///< key only where points were cut into tiles
  double read_seconds = 0;
  /// Of counting what was made; of the two passes over the input that reading is in `rbpa stream`. Keys only where there are such.
  std::optional<double> count_seconds = std::nullopt, cut_seconds = std::nullopt;
  std::optional<double> choose_seconds = std::nullopt;  ///< of the run that an alpha that is not given takes
  std::optional<double> build_seconds = std::nullopt;
  std::optional<double> write_seconds = std::nullopt;
};

/// One JSON object.
void write_stats(OutputFile& file, const Stats& stats);

/// The most memory that the process had.
std::size_t peak_bytes();

}  // namespace rbpa::app
