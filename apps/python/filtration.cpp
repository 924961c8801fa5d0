#include "rbpa/plane/filtration.h"

#include <limits>
#include <optional>
#include <tuple>

#include "python/module.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/persistence.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/plane/representatives.h"
#include "rbpa/plane/triangles_by_level.h"

namespace rbpa::python {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Delaunay delaunay_of(std::span<const Point> points, unsigned threads, Watch& watch) {
  return Delaunay(points, {.threads = threads, .progress = watch.progress()});
}

/// Returns the arguments of rbpa.Plateau for each plateau, the best first.
py::list plateaus_of(const Doubles& points, unsigned threads, const py::object& progress) {
  const auto input = points_of(points);
  const std::vector<Plateau> found = watched(input.size(), progress, [&](Watch& watch) {
    const Delaunay delaunay = delaunay_of(input, threads, watch);
    return plateaus(delaunay, filtration(delaunay, watch.until_stopped()), watch.until_stopped());
  });
  py::list list;
  for (const Plateau& p : found)
    list.append(py::make_tuple(p.from, p.to, p.alpha, p.ratio, p.step.triangles, p.step.solid_components,
                               p.step.components, p.step.holes, p.step.covered, p.step.area, p.effective_parts,
                               p.hole_share, p.kind == PlateauKind::structured ? "structured" : "one piece",
                               p.is_long));
  return list;
}

PairChoice pair_choice(double min_persistence, std::optional<std::size_t> top) {
  PairChoice choice{.min_persistence = min_persistence};
  if (top) choice.top = *top;
  return choice;
}

/// Returns the rings of a polygon as lists of input indices, the shell first.
py::list rings_of(Polygon polygon) {
  py::list rings;
  if (polygon.shell.points.empty()) return rings;
  rings.append(line<std::int32_t>(std::move(polygon.shell.points)));
  for (Ring& hole : polygon.holes) rings.append(line<std::int32_t>(std::move(hole.points)));
  return rings;
}

/// Returns the arguments of rbpa.Representative for each pair. If `levels` (radii) or `leaf_capacity` (for the levels
/// of hrbpa()) is given, the pairs are those of level_representatives().
py::list representatives_of(const Doubles& points, bool full, double min_persistence, std::optional<std::size_t> top,
                            std::optional<std::vector<double>> levels, std::optional<std::size_t> leaf_capacity,
                            unsigned threads, const py::object& progress) {
  const auto input = points_of(points);
  std::vector<Representative> found = watched(input.size(), progress, [&](Watch& watch) {
    const Delaunay delaunay = delaunay_of(input, threads, watch);
    const Filtration steps = filtration(delaunay, watch.until_stopped());
    const ComplexKind kind = full ? ComplexKind::full : ComplexKind::solid;
    const PairChoice choice = pair_choice(min_persistence, top);
    if (!levels && !leaf_capacity) return representatives(delaunay, steps, kind, choice, watch.until_stopped());
    if (leaf_capacity) {
      levels.emplace();
      for (const ArrayLevel& level :
           triangles_by_level(input, infinity, {.leaf_capacity = *leaf_capacity, .threads = threads}).levels)
        levels->push_back(level.alpha);
    }
    return level_representatives(delaunay, steps, *levels, kind, choice, watch.until_stopped());
  });
  py::list list;
  for (Representative& one : found) {
    py::object joined = py::none();
    if (one.joined_at) joined = py::make_tuple((*one.joined_at)[0], (*one.joined_at)[1]);
    const double area = one.at_birth.area;
    list.append(py::make_tuple(one.pair.dimension, one.pair.birth, one.pair.death.value_or(infinity), joined,
                               rings_of(std::move(one.at_birth)), rings_of(std::move(one.before_death)), area));
  }
  return list;
}

/// Returns the steps of the filtration, with an array for each member of a step.
py::dict filtration_steps(const Doubles& points, unsigned threads, const py::object& progress) {
  const auto input = points_of(points);
  Filtration made = watched(input.size(), progress, [&](Watch& watch) {
    return filtration(delaunay_of(input, threads, watch), watch.until_stopped());
  });
  const std::size_t distinct = made.distinct;
  const Kept steps(std::move(made.steps));
  py::dict result;
  result["alpha"] = view_column<double>(steps, &FiltrationStep::alpha);
  result["triangles"] = view_column<std::int64_t>(steps, &FiltrationStep::triangles);
  result["solid_components"] = view_column<std::int64_t>(steps, &FiltrationStep::solid_components);
  result["components"] = view_column<std::int64_t>(steps, &FiltrationStep::components);
  result["holes"] = view_column<std::int64_t>(steps, &FiltrationStep::holes);
  result["covered"] = view_column<std::int64_t>(steps, &FiltrationStep::covered);
  result["area"] = view_column<double>(steps, &FiltrationStep::area);
  result["distinct"] = distinct;
  return result;
}

using Interval = std::array<double, 2>;

/// Returns two arrays with rows (birth, death): the components, and the holes. Death is infinity if a pair never dies.
std::tuple<Doubles, Doubles> persistence_intervals(const Doubles& points, bool full, unsigned threads,
                                                   const py::object& progress) {
  const auto input = points_of(points);
  auto intervals = watched(input.size(), progress, [&](Watch& watch) {
    const Delaunay delaunay = delaunay_of(input, threads, watch);
    const Filtration made = filtration(delaunay, watch.until_stopped());
    std::array<std::vector<Interval>, 2> of_dimension;
    for (const PersistencePair& pair :
         persistence(delaunay, made, full ? ComplexKind::full : ComplexKind::solid, watch.until_stopped()))
      of_dimension[static_cast<std::size_t>(pair.dimension)].push_back({pair.birth, pair.death.value_or(infinity)});
    return of_dimension;
  });
  return {rows<double>(std::move(intervals[0])), rows<double>(std::move(intervals[1]))};
}

}  // namespace

void bind_filtration(py::module_& module) {
  using py::arg;
  module.def("plateaus", &plateaus_of, as_is("points"), arg("threads"), arg("progress"));
  module.def("representatives", &representatives_of, as_is("points"), arg("full"), arg("min_persistence"), arg("top"),
             arg("levels"), arg("leaf_capacity"), arg("threads"), arg("progress"));
  module.def("filtration", &filtration_steps, as_is("points"), arg("threads"), arg("progress"));
  module.def("persistence", &persistence_intervals, as_is("points"), arg("full"), arg("threads"), arg("progress"));
}

}  // namespace rbpa::python
