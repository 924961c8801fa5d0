#include "rbpa/plane/groups.h"

#include "python/flat_polygons.h"
#include "python/module.h"

namespace rbpa::python {
namespace {

/// Views an array of labels of shape (n,), which must outlive the span. −1, Python's label of points in no group, has
/// the bits of no_group.
std::span<const std::uint32_t> labels_of(const Indices& array) {
  static_assert(static_cast<std::uint32_t>(-1) == no_group);
  require_shape(array.ndim() == 1, array, "groups", "(n,)");
  return {reinterpret_cast<const std::uint32_t*>(array.data()), static_cast<std::size_t>(array.size())};
}

py::dict shapes_of_groups(const Doubles& points, const Indices& labels, std::size_t count, const Doubles& alphas,
                          const AlphaChoice& choice, double min_hole_area, double min_part_area, unsigned threads,
                          const py::object& progress) {
  const auto input = points_of(points);
  const auto of = labels_of(labels);
  const GroupAlpha alpha{.given = {alphas.data(), static_cast<std::size_t>(alphas.size())}, .choice = choice};
  std::vector<std::int64_t> counts;
  PolygonTotals all;
  GroupShapes made;
  FlatPolygons<std::uint32_t> flat;
  watched(input.size(), progress, [&](Watch& watch) {
    const Groups groups = groups_of(of, count);
    for (std::size_t g = 0; g < groups.size(); ++g) counts.push_back(static_cast<std::int64_t>(groups[g].size()));
    GroupShapesOptions options;
    options.threads = threads;
    options.go_on = [&, report = watch.progress()](std::size_t done) { return report({done, count}); };
    options.filter = {.min_hole_area = min_hole_area, .min_part_area = min_part_area};
    options.triangles = true;
    made = rbpa::shapes_of_groups(input, groups, alpha, options);
    for (const Polygon& polygon : made.polygons) flat.add(polygon);
    all = total(made.polygons);
    return true;
  });
  py::dict polygons = flat.as_arrays(all);
  py::dict problems;
  for (const GroupProblem& problem : made.problems) problems[py::int_(problem.group)] = problem.what;
  py::dict result;
  result["counts"] = line<std::int64_t>(std::move(counts));
  result["alphas"] = line<double>(std::move(made.alphas));
  result["areas"] = column<double>(made.totals, &PolygonTotals::area);
  result["perimeters"] = column<double>(made.totals, &PolygonTotals::perimeter);
  result["simplices"] = rows<std::int32_t>(std::move(made.triangles));
  result["simplex_begin"] = line<std::int64_t>(std::move(made.triangle_begin));
  result["polygon_begin"] = line<std::int64_t>(std::move(made.polygon_begin));
  result["polygons"] = polygons;
  result["problems"] = problems;
  return result;
}

}  // namespace

void bind_groups(py::module_& module) {
  using py::arg;
  module.def("shapes_of_groups", &shapes_of_groups, as_is("points"), as_is("labels"), arg("count"), as_is("alphas"),
             arg("choice"), arg("min_hole_area"), arg("min_part_area"), arg("threads"), arg("progress"));
}

}  // namespace rbpa::python
