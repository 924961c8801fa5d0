#include "rbpa/plane/outline_polygons.h"

#include "python/flat_polygons.h"
#include "python/module.h"

namespace rbpa::python {
namespace {

py::dict polygons(const Doubles& points, const Indices& simplices, const Indices& neighbors, double min_hole_area,
                  double min_part_area) {
  const auto input = points_of(points);
  const TriangleArrays triangles = triangle_arrays_of(simplices, neighbors);
  PolygonTotals totals;
  auto flat = watched(triangles.triangles.size(), py::none(), [&](Watch& watch) {
    const std::vector<Polygon> made = rbpa::outline_polygons(
        input, triangles, {.min_hole_area = min_hole_area, .min_part_area = min_part_area}, watch.until_stopped());
    FlatPolygons<std::uint32_t> all;
    for (const Polygon& polygon : made) all.add(polygon);
    totals = total(made);
    return all;
  });
  return flat.as_arrays(totals);
}

}  // namespace

void bind_polygons(py::module_& module) {
  using py::arg;
  module.def("polygons", &polygons, as_is("points"), as_is("simplices"), as_is("neighbors"), arg("min_hole_area"),
             arg("min_part_area"));
}

}  // namespace rbpa::python
