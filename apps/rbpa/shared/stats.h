// What: writes the report of --stats.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "io/bytes/output_file.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/topology.h"

namespace rbpa::app {

/// Counts of a filling of polygons.
struct FillStats {
  std::size_t on_boundary = 0;  ///< points that were put on edges
  std::size_t inside = 0;       ///< points that were put inside
  std::size_t retreats = 0;     ///< number of triangles that the front removed again
  std::size_t features = 0;     ///< features in the file
  std::size_t left_out = 0;     ///< features that are not valid
};

/// Counts of a run on groups of points.
struct GroupStats {
  std::size_t groups = 0;
  std::size_t without_polygon = 0;
  std::size_t triangles = 0;  ///< number of triangles in all groups together
};

struct Stats {
  std::size_t points = 0;
  std::size_t distinct = 0;
  unsigned threads = 1;  ///< the most threads that were used
  // The report has null for values that the verb does not compute.
  std::optional<double> alpha = std::nullopt;
  std::optional<std::string> alpha_rule = std::nullopt;
  std::optional<std::size_t> isolated = std::nullopt;
  std::optional<ComplexCounts> counts = std::nullopt;
  std::string method = "rbpa";                               ///< written if there are counts
  std::optional<std::size_t> dangling_edges = std::nullopt;  ///< key only for the full complex
  // The report has the keys for polygons only if the verb makes polygons.
  std::optional<std::size_t> polygons = std::nullopt;
  PolygonTotals of_polygons = {};
  std::optional<GroupStats> groups =
      std::nullopt;                              ///< keys only if present; then the values of a single complex are null
  std::optional<FillStats> fill = std::nullopt;  ///< keys only for `rbpa fill`
  std::optional<std::size_t> tiles = std::nullopt;  ///< key only if points were cut into tiles
  double read_seconds = 0;
  /// Seconds of counting the result, and of cutting tiles; in `rbpa stream`, of its two passes over the input. Keys
  /// only if present.
  std::optional<double> count_seconds = std::nullopt, cut_seconds = std::nullopt;
  std::optional<double> choose_seconds =
      std::nullopt;  ///< seconds of choosing alpha by a rule; absent if alpha was given
  std::optional<double> build_seconds = std::nullopt;
  std::optional<double> write_seconds = std::nullopt;
};

/// Writes one JSON object.
void write_stats(OutputFile& file, const Stats& stats);

/// Returns the peak memory of this process, in bytes.
std::size_t peak_bytes();

}  // namespace rbpa::app
