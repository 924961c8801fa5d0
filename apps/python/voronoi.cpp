#include "rbpa/plane/voronoi.h"

#include <string>

#include "python/flat_polygons.h"
#include "python/module.h"
#include "rbpa/fill/voronoi_cells.h"

namespace rbpa::python {
namespace {

/// Returns the members of rbpa.Voronoi; the vertices of all regions, one region after another, and where each begins.
py::dict voronoi_of(const Doubles& points, unsigned threads, const py::object& progress) {
  const auto input = points_of(points);
  Voronoi made = watched(input.size(), progress, [&](Watch& watch) {
    return rbpa::voronoi(Delaunay(input, {.threads = threads, .progress = watch.progress()}), watch.until_stopped());
  });
  std::vector<Point> directions(made.ridge_points.size());
  for (const UnboundedRidge& ridge : made.unbounded) directions[ridge.ridge] = ridge.direction;
  py::dict result;
  result["vertices"] = rows<double>(std::move(made.vertices));
  result["ridge_points"] = rows<std::int32_t>(std::move(made.ridge_points));
  result["ridge_vertices"] = rows<std::int32_t>(std::move(made.ridge_vertices));
  result["ridge_directions"] = rows<double>(std::move(directions));
  result["point_region"] = line<std::int32_t>(std::move(made.point_region));
  result["_of_regions"] = line<std::int32_t>(std::move(made.region_vertices));
  result["_begin"] = line<std::int64_t>(std::move(made.region_begin));
  return result;
}

/// Returns the cells within a boundary: "box", "hull", or "rings", whose corners are `corners`, one ring after another;
/// ring r begins at corner ring_begin[r], and polygon i with ring polygon_begin[i].
py::dict voronoi_cells_of(const Doubles& points, const std::string& boundary, const Doubles& corners,
                          const Begins& ring_begin, const Begins& polygon_begin, unsigned threads,
                          const py::object& progress) {
  const auto input = points_of(points);
  std::vector<Point> places(points_of(corners).begin(), points_of(corners).end());
  std::vector<Polygon> polygons;
  for (py::ssize_t i = 0; i + 1 < polygon_begin.size(); ++i) {
    Polygon& polygon = polygons.emplace_back();
    for (std::int64_t r = polygon_begin.at(i); r < polygon_begin.at(i + 1); ++r) {
      Ring& ring = r == polygon_begin.at(i) ? polygon.shell : polygon.holes.emplace_back();
      for (std::int64_t c = ring_begin.at(r); c < ring_begin.at(r + 1); ++c)
        ring.points.push_back(static_cast<std::uint32_t>(c));
    }
  }
  VoronoiCells made = watched(input.size(), progress, [&](Watch& watch) {
    const Delaunay delaunay(input, {.threads = threads, .progress = watch.progress()});
    if (boundary == "hull") {
      places.assign(input.begin(), input.end());
      polygons = outline_polygons(input, delaunay.triangulation());
    } else if (boundary == "box" && !input.empty()) {
      const auto box = box_around(input);
      places.assign(box.begin(), box.end());
      polygons = {{.shell = {{0, 1, 2, 3}}}};
    }
    return voronoi_cells(delaunay, places, polygons, watch.until_stopped());
  });
  FlatPolygons<std::uint32_t> flat;
  for (const Polygon& polygon : made.polygons) flat.add(polygon);
  py::dict result;
  result["vertices"] = rows<double>(std::move(made.points));
  result["polygons"] = flat.as_arrays(total(made.polygons));
  result["polygon_points"] = line<std::int32_t>(std::move(made.of));
  result["merged"] = made.merged;
  result["inserted"] = made.inserted;
  return result;
}

}  // namespace

void bind_voronoi(py::module_& module) {
  using py::arg;
  module.def("voronoi", &voronoi_of, as_is("points"), arg("threads"), arg("progress"));
  module.def("voronoi_cells", &voronoi_cells_of, as_is("points"), arg("boundary"), as_is("corners"),
             as_is("ring_begin"), as_is("polygon_begin"), arg("threads"), arg("progress"));
}

}  // namespace rbpa::python
