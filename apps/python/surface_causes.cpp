#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "python/module.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/repair/suggested_repairs.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/unused_points.h"

namespace rbpa::python {
namespace {

using Causes = py::array_t<std::uint8_t, py::array::c_style>;

/// The input of a surface. If there are no normals, the surface consists of the exposed triangles of one radius; if
/// there are no radii, no ball made the surface.
struct SurfaceInput {
  std::span<const Point3> points, normals;
  std::span<const double> radii;

  SurfaceInput(const Doubles& given_points, const MaybeDoubles& given_normals, const Doubles& given_radii)
      : points(points3_of(given_points, "points")),
        normals(points3_of(given_normals, "normals")),
        radii(line_of(given_radii)) {
    require_shape(given_radii.ndim() == 1, given_radii, "radii", "(k,)");
    if (!given_normals && radii.size() > 1)
      throw py::value_error("radii: found " + std::to_string(radii.size()) +
                            ", expected one, as the points have no normals (several radii require normals)");
  }
};

/// Returns the surface with copies of the arrays of Python.
Surface surface_again(const SurfaceInput& input, const Indices& triangles, const Indices& neighbors,
                      const Indices& levels, const Indices& duplicates) {
  Surface made;
  const auto corners = triples_of(triangles, "triangles"), others = triples_of(neighbors, "neighbors");
  if (others.size() != corners.size() || levels.ndim() != 1 ||
      static_cast<std::size_t>(levels.shape(0)) != corners.size())
    throw py::value_error("triangles, neighbors, levels: found arrays of lengths " + std::to_string(corners.size()) +
                          ", " + std::to_string(others.size()) + ", " + std::to_string(levels.size()) +
                          ", expected equal ones");
  require_rows(duplicates, "duplicates", 2);
  made.triangles.assign(corners.begin(), corners.end());
  made.neighbors.assign(others.begin(), others.end());
  if (input.radii.size() > 1) {
    made.levels.resize(corners.size());
    if (!made.levels.empty())
      std::memcpy(made.levels.data(), levels.data(), made.levels.size() * sizeof(made.levels[0]));
  }
  made.duplicates.resize(static_cast<std::size_t>(duplicates.shape(0)));
  static_assert(sizeof(Duplicate) == 2 * sizeof(std::int32_t));
  if (!made.duplicates.empty())
    std::memcpy(made.duplicates.data(), duplicates.data(), made.duplicates.size() * sizeof(Duplicate));
  made.distinct = input.points.size() - made.duplicates.size();
  return made;
}

/// Returns the sides of all boundary curves, with an array for each member of a side; the index of the first side of
/// each curve, and the end; and lengths and kinds of curves. If there are no radii, sides have no causes.
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
  result["from"] = view_column<std::int32_t>(edges, &RimEdge::from);
  result["to"] = view_column<std::int32_t>(edges, &RimEdge::to);
  result["triangle"] = view_column<std::int32_t>(edges, &RimEdge::triangle);
  result["level"] = view_column<std::int32_t>(edges, &RimEdge::level);
  result["cause"] = view_column<std::uint8_t>(edges, &RimEdge::cause);
  result["next"] = view_column<std::int32_t>(edges, &RimEdge::next);
  result["corners"] = view_column<bool>(edges, &RimEdge::corners);
  result["begin"] = line<std::int64_t>(std::move(begin));
  result["length"] = line<double>(std::move(lengths));
  result["kind"] = line<std::uint8_t>(std::move(kinds));
  return result;
}

/// Returns, for each curve of kind hole, its number, and the kind, the filling's outcome, the radius and the points of
/// the suggested repair. All points are in one array, with the index of the first point of each repair, and the end.
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

/// Returns the distinct points in no triangle, and for each point the number of the cause.
std::tuple<Indices, Causes> unused_of(const Doubles& points, const MaybeDoubles& normals, const Doubles& radii,
                                      const Indices& triangles, const Indices& neighbors, const Indices& levels,
                                      const Indices& duplicates, unsigned threads) {
  const SurfaceInput input(points, normals, radii);
  const Surface made = surface_again(input, triangles, neighbors, levels, duplicates);
  const auto found = watched(input.points.size(), py::none(), [&](Watch& watch) {
    const SurfaceOptions options = {.threads = threads, .progress = watch.progress()};
    return unused_points(input.points, input.normals, input.radii, made, options);
  });
  return {column<std::int32_t>(found, &UnusedPoint::index), column<std::uint8_t>(found, &UnusedPoint::cause)};
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
