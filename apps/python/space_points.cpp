#include <span>
#include <tuple>

#include "python/module.h"
#include "rbpa/space/normals/estimate_normals.h"
#include "rbpa/space/surface/outliers.h"
#include "rbpa/space/surface/scale_space.h"

namespace rbpa::python {
namespace {

/// Returns the estimated normals, and the confidence in each normal.
std::tuple<Doubles, Doubles> estimated(const Doubles& points, std::size_t neighbors, const MaybeDoubles& viewpoints,
                                       unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  const auto from = points3_of(viewpoints, "viewpoint");
  EstimatedNormals made = watched(input.size(), progress, [&](Watch& watch) {
    return estimate_normals_and_confidence(
        input, {.neighbors = neighbors, .viewpoints = from, .threads = threads, .progress = watch.progress()});
  });
  return {rows<double>(std::move(made.normals)), line<double>(std::move(made.confidence))};
}

/// Returns all points as moved by scale-space steps, and the number of steps.
std::tuple<Doubles, std::size_t> moved(const Doubles& points, std::size_t steps, std::size_t neighbors,
                                       unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  ScaleSpace made = watched(input.size(), progress, [&](Watch& watch) {
    return scale_space(input,
                       {.steps = steps, .neighbors = neighbors, .threads = threads, .progress = watch.progress()});
  });
  return {rows<double>(std::move(made.points)), made.steps};
}

/// Returns the input indices of outliers, and the median distance of a point from its last neighbor.
std::tuple<Indices, double> standing_alone(const Doubles& points, double factor, std::size_t neighbors,
                                           unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  Outliers found = watched(input.size(), progress, [&](Watch& watch) {
    return outliers(input,
                    {.factor = factor, .neighbors = neighbors, .threads = threads, .progress = watch.progress()});
  });
  return {line<std::int32_t>(std::move(found.points)), found.distance};
}

}  // namespace

void bind_space_points(py::module_& module) {
  using py::arg;
  module.def("estimate_normals", &estimated, as_is("points"), arg("neighbors"), as_is("viewpoints"), arg("threads"),
             arg("progress"));
  module.def("scale_space", &moved, as_is("points"), arg("steps"), arg("neighbors"), arg("threads"), arg("progress"));
  module.def("outliers", &standing_alone, as_is("points"), arg("factor"), arg("neighbors"), arg("threads"),
             arg("progress"));
}

}  // namespace rbpa::python
