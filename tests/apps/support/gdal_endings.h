// The endings of files of polygons that programs with GDAL list in messages behind those that all programs have.
#pragma once

#include <string>

#include "io/formats.h"

namespace apps_test {

inline std::string gdal_endings() { return rbpa::app::has_gdal() ? ", gpkg, fgb, shp" : ""; }

}  // namespace apps_test
