#include "rbpa/shape.h"

#include <pybind11/pybind11.h>

#include "python/arrays.h"
#include "python/module.h"
#include "python/watched.h"

namespace rbpa::python {
namespace {

/// All rings one after the other, the shell of each polygon before its holes; where rings begin, and which ring is the
/// first of each polygon; and the ends.
struct FlatPolygons {
  std::vector<std::uint32_t> points;
  std::vector<std::int64_t> ring_begin = {0}, polygon_begin = {0};
  std::vector<double> areas, perimeters;
  PolygonTotals totals;

  void add(const Ring& ring) {
    points.insert(points.end(), ring.points.begin(), ring.points.end());
    ring_begin.push_back(static_cast<std::int64_t>(points.size()));
  }
  void add(const Polygon& polygon) {
    add(polygon.shell);
    for (const Ring& hole : polygon.holes) add(hole);
    polygon_begin.push_back(static_cast<std::int64_t>(ring_begin.size()) - 1);
    areas.push_back(polygon.area);
    perimeters.push_back(polygon.perimeter);
  }
};

py::dict polygons(const Doubles& points, const Indices& simplices, const Indices& neighbors, double min_hole_area,
                  double min_part_area) {
  const auto input = points_of(points);
  const TriangleArrays triangles = triangle_arrays_of(simplices, neighbors);
  FlatPolygons flat = watched(triangles.triangles.size(), py::none(), [&](Watch& watch) {
    const std::vector<Polygon> made = rbpa::polygons(
        input, triangles, {.min_hole_area = min_hole_area, .min_part_area = min_part_area}, watch.until_stopped());
    FlatPolygons all;
    for (const Polygon& polygon : made) all.add(polygon);
    all.totals = total(made);
    return all;
  });
  py::dict result;
  result["area"] = flat.totals.area;
  result["perimeter"] = flat.totals.perimeter;
  result["indices"] = line<std::int32_t>(std::move(flat.points));
  result["ring_begin"] = line<std::int64_t>(std::move(flat.ring_begin));
  result["polygon_begin"] = line<std::int64_t>(std::move(flat.polygon_begin));
  result["areas"] = line<double>(std::move(flat.areas));
  result["perimeters"] = line<double>(std::move(flat.perimeters));
  return result;
}

}  // namespace

void bind_polygons(py::module_& module) {
  using py::arg;
  module.def("polygons", &polygons, arg("points").noconvert(), arg("simplices").noconvert(),
             arg("neighbors").noconvert(), arg("min_hole_area"), arg("min_part_area"));
}

}  // namespace rbpa::python
