// What: the request of a run of `rbpa stream`: inputs, outputs and limits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"

namespace rbpa::app {

enum class StreamFormat {
  npy,      ///< triangles, with the bytes of `rbpa mesh`
  geojson,  ///< polygons, as `rbpa shape` writes them
  wkt,      ///< polygons, as `rbpa shape` writes them
  ply       ///< a mesh for each tile: the name has a '*' for the number of the tile
};

struct StreamTarget {
  std::string path;
  StreamFormat format;
};

struct StreamRequest {
  std::vector<PointSource> sources = {};
  std::string options = {};  ///< the options about reading the sources, as text
  double alpha = 0;
  std::uint64_t memory = 0;                               ///< memory in bytes
  std::optional<std::uint64_t> tile_size = std::nullopt;  ///< the most points that a tile may own
  std::optional<std::string> scratch = std::nullopt;  ///< the folder; absent: a new folder in that of the first target
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
};

}  // namespace rbpa::app
