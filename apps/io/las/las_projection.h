// What: the coordinate reference system of a LAS file, from its variable length records.
#pragma once

#include <optional>
#include <string_view>

#include "io/crs.h"
#include "io/las/las_header.h"

namespace rbpa::app {

/// That of well-known text, else of GeoTIFF keys; nothing where neither names one by its EPSG code. Records that claim
/// more than there is end the search: they are about the points, and none of them.
std::optional<Crs> las_crs(std::string_view bytes, const LasHeader& header);

}  // namespace rbpa::app
