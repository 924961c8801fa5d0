// What: defines the request of a run of `rbpa stream`: inputs, outputs and limits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa::app {

enum class StreamFormat {
  npy,      ///< triangles, with the bytes that `rbpa mesh` writes
  geojson,  ///< polygons, with the bytes that `rbpa shape` writes
  wkt,      ///< polygons, with the bytes that `rbpa shape` writes
  ply       ///< one mesh for each tile: the path has a '*' in place of the number of the tile
};

struct StreamTarget {
  std::string path;
  StreamFormat format;
};

struct StreamRequest {
  std::vector<PointSource> sources = {};
  std::string options = {};  ///< the options that tell how the sources are read, as text
  double alpha = 0;
  PolygonFilter filter = {};
  std::uint64_t memory = 0;                               ///< memory in bytes
  std::optional<std::uint64_t> tile_size = std::nullopt;  ///< the most points in the box of a tile
  std::optional<std::string> scratch = std::nullopt;      ///< the folder; nullopt: a new folder beside the first target
  bool keep_tiles = false;
  bool resume = false;
  unsigned threads = 1;  ///< the most threads
  bool quiet = false;
  bool shows_progress = false;
  std::vector<StreamTarget> targets = {};
  std::optional<std::string> stats = std::nullopt;

  bool wants(StreamFormat format) const {
    for (const StreamTarget& target : targets)
      if (target.format == format) return true;
    return false;
  }
  bool wants_polygons() const { return wants(StreamFormat::geojson) || wants(StreamFormat::wkt); }
  bool filters() const { return filter.min_hole_area > 0 || filter.min_part_area > 0; }
};

}  // namespace rbpa::app
