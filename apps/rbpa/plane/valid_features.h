// What: selects the valid features of a file of polygons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/polygon/polygon_file.h"

namespace rbpa::app {

struct ValidFeatures {
  std::vector<Polygon> polygons = {};
  std::vector<std::size_t> groups = {};        ///< index of the first polygon of each geometry, as fill() requires
  std::vector<std::uint32_t> feature = {};     ///< number of the feature of each geometry
  std::vector<std::string> why_left_out = {};  ///< fault of each invalid feature, after its number if there are several
};

/// Returns the valid features. A feature is valid if each of its geometries is a valid multipolygon (fill/validity.h).
/// Throws BadInput that names the first invalid feature, unless `skip_invalid`; Cancelled. Cost: O(n log n) for n
/// points.
ValidFeatures valid_features(const PolygonFile& file, const std::string& name, bool skip_invalid);

}  // namespace rbpa::app
