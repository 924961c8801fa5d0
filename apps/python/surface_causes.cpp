#include <cstdint>
#include <tuple>
#include <vector>

#include "python/module.h"
#include "python/surface_input.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/repair/suggested_repairs.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/unused_points.h"

namespace rbpa::python {
namespace {

using Causes = py::array_t<std::uint8_t, py::array::c_style>;

/// Returns the sides of all boundary curves as columns, and the begin of each curve. Without radii the surface was not
/// made by a ball, and sides have no cause.
py::dict holes_of(const Doubles& points, const MaybeDoubles& normals, const Doubles& radii, const Indices& triangles,
                  const Indices& neighbors, const Indices& levels, const Indices& duplicates, unsigned threads) {
  const SurfaceInput input(points, normals, radii);
  const Surface made = surface_again(input, triangles, neighbors, levels, duplicates);
  std::vector<std::int64_t> begin = {0};
  std::vector<double> lengths;
  std::vector<std::uint8_t> kinds;
  std::vector<RimEdge> all;
  watched(input.points.size(), py::none(), [&](Watch& watch) {
    const SurfaceOptions options = {.threads = threads, .progress = watch.progress()};
    const std::vector<Hole> found = input.radii.empty()
                                        ? surface_curves(input.points, made, watch.until_stopped())
                                        : holes(input.points, input.normals, input.radii, made, options);
    for (const CurveKind kind :
         curve_kinds(input.points, surface_components(input.points, made, watch.until_stopped()), found))
      kinds.push_back(static_cast<std::uint8_t>(kind));
    for (const Hole& hole : found) {
      all.insert(all.end(), hole.edges.begin(), hole.edges.end());
      begin.push_back(static_cast<std::int64_t>(all.size()));
      lengths.push_back(hole.length);
    }
    return 0;
  });
  py::dict result;
  const Kept edges(std::move(all));
  const auto column = [&]<typename Number>(const char* name, auto RimEdge::*member, py::ssize_t columns, Number) {
    const void* first = edges->empty() ? nullptr : &((*edges)[0].*member);
    std::vector<py::ssize_t> shape = {py::ssize_t(edges->size())}, strides = {py::ssize_t(sizeof(RimEdge))};
    if (columns > 0) {
      shape.push_back(columns);
      strides.push_back(py::ssize_t(sizeof(Number)));
    }
    result[name] = edges.view<Number>(first, std::move(shape), std::move(strides));
  };
  static_assert(sizeof(RimCause) == 1 && sizeof(bool) == 1);
  column("from", &RimEdge::from, 0, std::int32_t{});
  column("to", &RimEdge::to, 0, std::int32_t{});
  column("triangle", &RimEdge::triangle, 0, std::int32_t{});
  column("level", &RimEdge::level, 0, std::int32_t{});
  column("cause", &RimEdge::cause, 0, std::uint8_t{});
  column("next", &RimEdge::next, 3, std::int32_t{});
  column("corners", &RimEdge::corners, 3, bool{});
  column("sides", &RimEdge::sides, 3, bool{});
  result["begin"] = line<std::int64_t>(std::move(begin));
  result["length"] = line<double>(std::move(lengths));
  result["kind"] = line<std::uint8_t>(std::move(kinds));
  return result;
}

/// Returns for each curve of kind hole its number, the kind of the suggested repair, the radius, the begin of its
/// points, and these points.
py::dict repairs_of(const Doubles& points, const Doubles& normals, const Doubles& radii, const Indices& triangles,
                    const Indices& neighbors, const Indices& levels, const Indices& duplicates, unsigned threads,
                    const py::object& progress) {
  const SurfaceInput input(points, normals, radii);
  const Surface made = surface_again(input, triangles, neighbors, levels, duplicates);
  std::vector<std::int32_t> number;
  const auto found = watched(input.points.size(), progress, [&](Watch& watch) {
    const SurfaceOptions options = {.threads = threads, .progress = watch.progress()};
    const std::vector<Hole> curves = holes(input.points, input.normals, input.radii, made, options);
    const std::vector<CurveKind> kinds =
        curve_kinds(input.points, surface_components(input.points, made, watch.until_stopped()), curves);
    for (std::size_t i = 0; i < curves.size(); ++i)
      if (kinds[i] == CurveKind::hole) number.push_back(static_cast<std::int32_t>(i));
    return suggested_repairs(input.points, input.normals, input.radii, made, chosen_curves(curves, kinds), options);
  });
  std::vector<std::uint8_t> kinds, outcomes;
  std::vector<double> larger;
  std::vector<std::int64_t> begin = {0};
  std::vector<std::int32_t> turned;
  constexpr std::uint8_t not_tried = 255;
  for (const SuggestedRepair& repair : found) {
    kinds.push_back(static_cast<std::uint8_t>(repair.kind));
    outcomes.push_back(repair.filled ? static_cast<std::uint8_t>(*repair.filled) : not_tried);
    larger.push_back(repair.radius);
    for (const std::uint32_t point : repair.points) turned.push_back(static_cast<std::int32_t>(point));
    begin.push_back(static_cast<std::int64_t>(turned.size()));
  }
  py::dict result;
  result["hole"] = line<std::int32_t>(std::move(number));
  result["kind"] = line<std::uint8_t>(std::move(kinds));
  result["filled"] = line<std::uint8_t>(std::move(outcomes));
  result["radius"] = line<double>(std::move(larger));
  result["points"] = line<std::int32_t>(std::move(turned));
  result["begin"] = line<std::int64_t>(std::move(begin));
  return result;
}

/// Returns the points without a triangle, and the number of the cause of each.
std::tuple<Indices, Causes> unused_of(const Doubles& points, const MaybeDoubles& normals, const Doubles& radii,
                                      const Indices& triangles, const Indices& neighbors, const Indices& levels,
                                      const Indices& duplicates, unsigned threads) {
  const SurfaceInput input(points, normals, radii);
  const Surface made = surface_again(input, triangles, neighbors, levels, duplicates);
  const auto found = watched(input.points.size(), py::none(), [&](Watch& watch) {
    const SurfaceOptions options = {.threads = threads, .progress = watch.progress()};
    return unused_points(input.points, input.normals, input.radii, made, options);
  });
  std::vector<std::uint32_t> indices;
  std::vector<std::uint8_t> causes;
  for (const UnusedPoint& point : found) {
    indices.push_back(point.index);
    causes.push_back(static_cast<std::uint8_t>(point.cause));
  }
  return {line<std::int32_t>(std::move(indices)), line<std::uint8_t>(std::move(causes))};
}

}  // namespace

void bind_surface_causes(py::module_& module) {
  using py::arg;
  module.def("surface_holes", &holes_of, as_is("points"), as_is("normals"), as_is("radii"), as_is("triangles"),
             as_is("neighbors"), as_is("levels"), as_is("duplicates"), arg("threads"));
  module.def("surface_repairs", &repairs_of, as_is("points"), as_is("normals"), as_is("radii"), as_is("triangles"),
             as_is("neighbors"), as_is("levels"), as_is("duplicates"), arg("threads"), arg("progress"));
  module.def("surface_unused", &unused_of, as_is("points"), as_is("normals"), as_is("radii"), as_is("triangles"),
             as_is("neighbors"), as_is("levels"), as_is("duplicates"), arg("threads"));
}

}  // namespace rbpa::python
