// What: writes the report of --stats.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "io/bytes/output_file.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/topology.h"

namespace rbpa::app {

/// The counts of a filling of polygons.
struct FillStats {
  std::size_t on_boundary = 0;  ///< number of points added on edges
  std::size_t inside = 0;       ///< number of points added in the inside
  std::size_t retreats = 0;     ///< number of triangles that the front removed again
  std::size_t features = 0;     ///< number of features in the file
  std::size_t left_out = 0;     ///< number of features that are not valid
};

/// The counts of a run on groups of points.
struct GroupStats {
  std::size_t groups = 0;
  std::size_t without_polygon = 0;
  std::size_t triangles = 0;  ///< number of triangles in all groups together
};

struct Stats {
  std::size_t points = 0;
  std::size_t distinct = 0;
  unsigned threads = 1;  ///< the most threads that were used
  // The report has null for values that a verb does not compute.
  std::optional<double> alpha = std::nullopt;
  std::optional<std::string> alpha_rule = std::nullopt;
  std::optional<std::size_t> isolated = std::nullopt;
  std::optional<ComplexCounts> counts = std::nullopt;
  std::string method = "rbpa";                               ///< written if `counts` has a value
  std::optional<std::size_t> dangling_edges = std::nullopt;  ///< key only for the full complex
  // The report has the keys about polygons only if the verb makes polygons.
  std::optional<std::size_t> polygons = std::nullopt;
  PolygonTotals of_polygons = {};
  std::optional<GroupStats> groups =
      std::nullopt;                              ///< keys only for groups; the values of a single complex are null then
  std::optional<FillStats> fill = std::nullopt;  ///< keys only for `rbpa fill`
  std::optional<std::size_t> tiles = std::nullopt;  ///< key only if points were cut into tiles
  double read_seconds = 0;
  /// Seconds of counting the result, and of cutting tiles; in `rbpa stream`, of its two passes over the input. The
  /// report has the key of each only if it has a value.
  std::optional<double> count_seconds = std::nullopt, cut_seconds = std::nullopt;
  std::optional<double> choose_seconds =
      std::nullopt;  ///< seconds of choosing alpha by a rule; nullopt if alpha was given
  std::optional<double> build_seconds = std::nullopt;
  std::optional<double> write_seconds = std::nullopt;
};

/// Writes the report as one JSON object.
void write_stats(OutputFile& file, const Stats& stats);

/// Writes `report`, to which the threads, the seconds of each step and the peak memory are added.
void write_stats(OutputFile& file, nlohmann::ordered_json report, unsigned threads,
                 const nlohmann::ordered_json& seconds);

}  // namespace rbpa::app
