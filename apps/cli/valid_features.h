// What: those features of a file of polygons that are valid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/polygon/polygon_file.h"

namespace rbpa::app {

struct ValidFeatures {
  std::vector<Polygon> polygons = {};
  std::vector<std::size_t> groups = {};        ///< where each geometry begins, as fill() takes them
  std::vector<std::uint32_t> feature = {};     ///< of each geometry
  std::vector<std::string> why_left_out = {};  ///< of each feature that is not valid: which it is, and why
};

/// With skip_invalid without the features of which a geometry is no valid multipolygon (fill/validity.h).
/// Throws: BadInput that names the first of these otherwise; Cancelled. Cost: n log n.
ValidFeatures valid_features(const PolygonFile& file, const std::string& name, bool skip_invalid);

}  // namespace rbpa::app
