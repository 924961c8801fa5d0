// What: the coordinate reference system of a LAS file, from its variable length records.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/crs.h"
#include "io/las/las_header.h"

namespace rbpa::app {

struct LasCrs {
  std::optional<Crs> crs = std::nullopt;  ///< by its EPSG code
  std::string remark = {};                ///< why there is none although the file has one
};

/// That of well-known text, else of GeoTIFF keys. Records that claim more than there is end the search: they are about
/// the points, and none of them.
LasCrs las_crs(std::string_view bytes, const LasHeader& header);

}  // namespace rbpa::app
