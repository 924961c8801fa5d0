// What: runs `rbpa stream`, and the verbs that hold all points in memory, on the same points, in this process.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "shared/arguments.h"
#include "support/program.h"

namespace stream_test {

/// The bytes of both kinds of targets, and the number, area and perimeter of all polygons in the statistics.
struct Made {
  std::string triangles, polygons, text, totals = {};
  friend bool operator==(const Made&, const Made&) = default;
};

/// Returns the points as pairs of float64.
std::string raw(std::span<const rbpa::Point> points);

/// Reads the files t.npy, p.geojson, p.wkt and s.json (of --stats) of the folder, and removes them.
Made take(const apps_test::Folder& folder);

/// Returns the results of `rbpa mesh` and `rbpa shape` for a file in the folder.
Made wanted(const apps_test::Folder& folder, const std::string& file, double alpha,
            const rbpa::app::AreaArguments& areas = {});

struct How {
  std::uint64_t tile_size = 0;  ///< 0: as memory allows
  std::uint64_t memory = std::uint64_t{1} << 30U;
  unsigned threads = 2;
  rbpa::app::AreaArguments areas = {};
};

/// Returns the results of `rbpa stream` for files in the folder. Checks that no other file is left.
Made streamed(const apps_test::Folder& folder, const std::vector<std::string>& files, double alpha, const How& how);

}  // namespace stream_test
