#include <tuple>

#include "python/flat_polygons.h"
#include "python/module.h"
#include "rbpa/space/balls/measure_discs.h"

namespace rbpa::python {
namespace {

/// Returns the members of rbpa.Discs, with tuples in place of curves.
py::dict discs_of(const Doubles& centers, const Doubles& radii, unsigned threads, const py::object& progress) {
  const auto input = points_of(centers);
  DiscMeasures made = watched(input.size(), progress, [&](Watch& watch) {
    return measure_discs(input, line_of(radii), {.threads = threads, .progress = watch.progress()});
  });
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
  result["boundary"] = std::move(curves);
  return result;
}

/// Returns the arguments of rbpa.Polygons. `boundary` is that of rbpa.Discs.
std::tuple<Doubles, py::dict, Indices> disc_polygons_of(const Doubles& centers, const Doubles& radii,
                                                        const py::list& boundary, unsigned corners) {
  DiscMeasures measures;
  for (const py::handle of : boundary) {
    DiscCurve& curve = measures.boundary.emplace_back();
    const auto discs = of.attr("discs").cast<Indices>();
    const auto begins = of.attr("begins").cast<Doubles>(), angles = of.attr("angles").cast<Doubles>();
    for (py::ssize_t k = 0; k < discs.size(); ++k)
      curve.arcs.push_back({static_cast<std::uint32_t>(discs.data()[k]), begins.data()[k], angles.data()[k]});
    curve.component = of.attr("component").cast<std::uint32_t>();
    curve.is_hole = of.attr("is_hole").cast<bool>();
  }
  const auto input = points_of(centers);
  DiscPolygons made = watched(input.size(), py::none(), [&](Watch& watch) {
    return disc_polygons(measures, input, line_of(radii), corners, watch.until_stopped());
  });
  FlatPolygons<std::uint32_t> flat;
  for (const Polygon& polygon : made.polygons) flat.add(polygon);
  py::dict of_polygons = flat.as_arrays(total(made.polygons));
  return {rows<double>(std::move(made.points)), std::move(of_polygons), line<std::int32_t>(std::move(made.components))};
}

}  // namespace

void bind_discs(py::module_& module) {
  using py::arg;
  module.def("measure_discs", &discs_of, as_is("centers"), as_is("radii"), arg("threads"), arg("progress"));
  module.def("disc_polygons", &disc_polygons_of, as_is("centers"), as_is("radii"), arg("boundary"), arg("corners"));
}

}  // namespace rbpa::python
