#include "rbpa/plane/outline_polygons.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "python/flat_polygons.h"
#include "python/module.h"
#include "rbpa/plane/polygon_of_points.h"

namespace rbpa::python {
namespace {

using Longs = py::array_t<std::int64_t, py::array::c_style>;

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

/// Returns for each polygon of flat arrays the number of `queries` that are in it and in no polygon before it.
Longs points_in_polygons(const Doubles& points, const Indices& indices, const Longs& ring_begin,
                         const Longs& polygon_begin, const Doubles& queries) {
  const auto corners = points_of(points), input = points_of(queries);
  std::vector<Polygon> all;
  const auto ring = [&](std::int64_t r) {
    return Ring{.points = {indices.data() + ring_begin.at(r), indices.data() + ring_begin.at(r + 1)}};
  };
  for (py::ssize_t i = 0; i + 1 < polygon_begin.size(); ++i) {
    Polygon& polygon = all.emplace_back();
    polygon.shell = ring(polygon_begin.at(i));
    for (std::int64_t r = polygon_begin.at(i) + 1; r < polygon_begin.at(i + 1); ++r) polygon.holes.push_back(ring(r));
  }
  const auto found = watched(input.size(), py::none(), [&](Watch& watch) {
    return polygon_of_points(all, corners, input, watch.until_stopped());
  });
  std::vector<std::int64_t> counts(all.size());
  for (const std::optional<std::uint32_t>& polygon : found)
    if (polygon) ++counts[*polygon];
  return line<std::int64_t>(std::move(counts));
}

}  // namespace

void bind_polygons(py::module_& module) {
  using py::arg;
  module.def("points_in_polygons", &points_in_polygons, as_is("points"), as_is("indices"), as_is("ring_begin"),
             as_is("polygon_begin"), as_is("queries"));
  module.def("polygons", &polygons, as_is("points"), as_is("simplices"), as_is("neighbors"), arg("min_hole_area"),
             arg("min_part_area"));
}

}  // namespace rbpa::python
