#include "plane/triangle_outputs.h"

#include "io/polygon/ogr.h"
#include "io/polygon/write_shapes.h"
#include "plane/shape_outputs.h"

namespace rbpa::app {

void add_triangles(Run& run, const Target& target, const TriangleMesh& mesh, const PointFile& about) {
  stop_if_interrupted();
  const auto list = [&] { return table_of_triangles(mesh, about.crs, about.degrees); };
  if (is_ogr(target.format)) return add_ogr(run, target, ogr_triangles(target.format, list()));
  run.add(target.path, [&](OutputFile& file) {
    target.format == Format::geojson ? write_triangles_geojson(file, list())
                                     : write_triangles(file, target.format, mesh);
  });
}

void caution(const std::vector<Target>& targets, std::span<const Point> points, const PointFile& about) {
  caution(targets, Shape{points, {}, {}, about.crs, about.degrees});
}

}  // namespace rbpa::app
