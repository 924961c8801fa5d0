#include "io/ogr/ogr.h"

namespace rbpa::app {

bool is_ogr(ShapeFormat format) {
  return format == ShapeFormat::gpkg || format == ShapeFormat::fgb || format == ShapeFormat::shp;
}

std::vector<std::string> ogr_endings(ShapeFormat format) {
  if (format == ShapeFormat::gpkg) return {"gpkg"};
  if (format == ShapeFormat::fgb) return {"fgb"};
  return {"shp", "shx", "dbf", "prj", "cpg"};
}

}  // namespace rbpa::app
