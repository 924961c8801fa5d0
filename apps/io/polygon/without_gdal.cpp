#include "io/failure.h"
#include "io/polygon/ogr.h"

namespace rbpa::app {
namespace {

[[noreturn]] void refuse() {
  throw WrongUsage("found a format of GDAL, expected a program that is built with GDAL (libgdal-dev)");
}

}  // namespace

bool has_gdal() { return false; }
PointFile read_ogr_points(const std::string& /*source*/, const std::optional<std::string>& /*layer*/,
                          bool /*vertices*/) {
  refuse();
}
std::vector<OgrFile> ogr_polygons(Format /*format*/, const Shape& /*shape*/) { refuse(); }
std::vector<OgrFile> ogr_groups(Format /*format*/, const NamedShapes& /*groups*/) { refuse(); }
std::vector<OgrFile> ogr_triangles(Format /*format*/, const TriangleTable& /*triangles*/) { refuse(); }
std::vector<OgrFile> ogr_isolated(Format /*format*/, const Shape& /*shape*/) { refuse(); }

}  // namespace rbpa::app
