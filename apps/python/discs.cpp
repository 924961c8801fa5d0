#include "python/flat_polygons.h"
#include "python/module.h"
#include "rbpa/space/balls/measure_discs.h"

namespace rbpa::python {
namespace {

/// Returns the members of rbpa.Discs, the arcs of all curves, one curve after another, and the polygons.
py::dict discs_of(const Doubles& centers, const Doubles& radii, unsigned corners, unsigned threads,
                  const py::object& progress) {
  const auto input = points_of(centers);
  DiscPolygons polygons;
  DiscMeasures made = watched(input.size(), progress, [&](Watch& watch) {
    DiscMeasures measures = measure_discs(input, line_of(radii), {.threads = threads, .progress = watch.progress()});
    polygons = disc_polygons(measures, input, line_of(radii), corners, watch.until_stopped());
    return measures;
  });
  FlatPolygons<std::uint32_t> flat;
  for (const Polygon& polygon : polygons.polygons) flat.add(polygon);
  const PolygonTotals totals = total(polygons.polygons);
  py::dict of_polygons = flat.as_arrays();
  of_polygons["area"] = totals.area;
  of_polygons["perimeter"] = totals.perimeter;
  py::list curves;
  for (const DiscCurve& curve : made.boundary)
    curves.append(py::make_tuple(
        column<std::int32_t>(curve.arcs, &DiscArc::disc), column<double>(curve.arcs, &DiscArc::begin),
        column<double>(curve.arcs, &DiscArc::angle), curve.component, curve.is_hole, curve.area, curve.length));
  py::dict result;
  result["area"] = made.area;
  result["length"] = made.length;
  result["areas"] = line<double>(std::move(made.areas));
  result["lengths"] = line<double>(std::move(made.lengths));
  result["components"] = line<std::int32_t>(std::move(made.components));
  result["hidden"] = line<std::int32_t>(std::move(made.hidden));
  result["curves"] = std::move(curves);
  result["corners"] = rows<double>(std::move(polygons.points));
  result["polygons"] = std::move(of_polygons);
  return result;
}

}  // namespace

void bind_discs(py::module_& module) {
  using py::arg;
  module.def("measure_discs", &discs_of, as_is("centers"), as_is("radii"), arg("corners"), arg("threads"),
             arg("progress"));
}

}  // namespace rbpa::python
