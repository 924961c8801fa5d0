#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "io/lowest_values.h"
#include "python/module.h"
#include "rbpa/plane/contours.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/interpolate_grid.h"

namespace rbpa::python {
namespace {

/// Triangles with their neighbors.
using MaybeTriangles = std::optional<std::pair<Indices, Indices>>;

/// Returns the values of a raster, top row first, and its lower left corner. Interpolates in the given triangles of a
/// constrained triangulation, else in those of the Delaunay triangulation.
std::tuple<Doubles, double, double> grid_of(const Doubles& points, const Doubles& values, const MaybeTriangles& given,
                                            double alpha, double cell, const Doubles& extent, bool by_natural_neighbors,
                                            unsigned threads, const py::object& progress) {
  const auto input = points_of(points);
  const double* const at = extent.data();
  const Raster raster = raster_around({at[0], at[1]}, {at[2], at[3]}, cell);
  std::vector<double> cells = watched(input.size(), progress, [&](Watch& watch) {
    std::optional<Delaunay> delaunay;
    if (!given) delaunay.emplace(input, AlphaComplexOptions{.threads = threads, .progress = watch.progress()});
    TriangleArrays triangles =
        given ? triangle_arrays_of(given->first, given->second) : TriangleArrays(delaunay->triangulation());
    triangles.is_constrained = given.has_value();
    const Locator locator(input, triangles, {.threads = threads, .go_on = watch.until_stopped()});
    std::vector<double> all;
    all.reserve(raster.columns * raster.rows);
    interpolate_grid(locator, line_of(values), raster,
                     [&](std::span<const double> next) { all.insert(all.end(), next.begin(), next.end()); },
                     {.method = by_natural_neighbors ? Interpolation::natural_neighbor : Interpolation::linear,
                      .threads = threads,
                      .go_on = watch.until_stopped(),
                      .alpha = alpha});
    return all;
  });
  return {array_of<double>(std::move(cells), 0).reshape({py::ssize_t(raster.rows), py::ssize_t(raster.columns)}),
          raster.origin.x, raster.origin.y};
}

/// Returns for each line its level, whether it is closed, and its points.
py::list contours_of(const Doubles& points, const Indices& simplices, const Indices& neighbors, const Doubles& values,
                     const Doubles& levels, unsigned threads, const py::object& progress) {
  const auto input = points_of(points);
  const TriangleArrays triangles = triangle_arrays_of(simplices, neighbors);
  const Contours lines = watched(input.size(), progress, [&](Watch& watch) {
    return contours(input, triangles, line_of(values), line_of(levels),
                    {.threads = threads, .go_on = watch.until_stopped()});
  });
  py::list result;
  for (const Contour& line : lines)
    result.append(py::make_tuple(levels.at(py::ssize_t(line.level)), line.is_closed,
                                 rows<double>(std::vector<Point>(line.points.begin(), line.points.end()))));
  return result;
}

/// Returns a copy of values, with a row for each point, in which the lowest of each column at one place counts, and the
/// number of places with several values. `duplicates` is that of rbpa.Delaunay.
std::tuple<Doubles, std::size_t> with_lowest(const Doubles& values, const Indices& duplicates) {
  Doubles lowest(std::vector<py::ssize_t>(values.shape(), values.shape() + values.ndim()));
  std::copy(values.data(), values.data() + values.size(), lowest.mutable_data());
  std::vector<Duplicate> all;
  for (py::ssize_t i = 0; i < duplicates.shape(0); ++i)
    all.push_back({static_cast<std::uint32_t>(duplicates.at(i, 0)), static_cast<std::uint32_t>(duplicates.at(i, 1))});
  const auto columns = static_cast<std::size_t>(values.ndim() == 2 ? values.shape(1) : 1);
  const std::size_t places =
      app::take_lowest(all, {lowest.mutable_data(), static_cast<std::size_t>(lowest.size())}, columns);
  return {std::move(lowest), places};
}

}  // namespace

void bind_heights(py::module_& module) {
  using py::arg;
  module.def("grid", &grid_of, as_is("points"), as_is("values"), arg("triangles"), arg("alpha"), arg("cell"),
             as_is("extent"), arg("by_natural_neighbors"), arg("threads"), arg("progress"));
  module.def("contours", &contours_of, as_is("points"), as_is("simplices"), as_is("neighbors"), as_is("values"),
             as_is("levels"), arg("threads"), arg("progress"));
  module.def("with_lowest", &with_lowest, as_is("values"), as_is("duplicates"));
  module.def(
      "levels_every",
      [](double step, const Doubles& values) { return line<double>(levels_every(step, line_of(values))); }, arg("step"),
      as_is("values"));
}

}  // namespace rbpa::python
