// What: the same points by `rbpa stream` and by the verbs that have them all in memory, in this process.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "support/program.h"

namespace stream_test {

/// The bytes of both kinds of targets, and what the run says of all polygons: their number, area and perimeter.
struct Made {
  std::string triangles, polygons, text, totals = {};
  friend bool operator==(const Made&, const Made&) = default;
};

/// Pairs of float64.
std::string raw(std::span<const rbpa::Point> points);

/// The files t.npy, p.geojson, p.wkt and s.json (of --stats) of the folder, which go.
Made take(const apps_test::Folder& folder);

/// What `rbpa mesh` and `rbpa shape` make of a file in the folder.
Made wanted(const apps_test::Folder& folder, const std::string& file, double alpha);

struct How {
  std::uint64_t tile_size = 0;  ///< 0: as memory allows
  std::uint64_t memory = std::uint64_t{1} << 30U;
  unsigned threads = 2;
};

/// What `rbpa stream` makes of files in the folder, and leaves no other file there.
Made streamed(const apps_test::Folder& folder, const std::vector<std::string>& files, double alpha, const How& how);

}  // namespace stream_test
