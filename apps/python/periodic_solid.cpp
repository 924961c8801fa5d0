#include "rbpa/space/solid/periodic_solid.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "python/module.h"
#include "rbpa/space/balls/periodic_topology.h"
#include "rbpa/space/persistence/choose_solid_alpha.h"
#include "rbpa/space/solid/solid_radii.h"

namespace rbpa::python {
namespace {

using Box = std::tuple<double, double, double>;

Point3 sides_of(const Box& box) { return {std::get<0>(box), std::get<1>(box), std::get<2>(box)}; }

py::dict arrays_of(PeriodicSolid made) {
  std::vector<std::uint32_t> points;
  std::vector<std::array<std::int8_t, 3>> offsets;
  for (const PeriodicVertex& vertex : made.vertices) {
    points.push_back(vertex.point);
    offsets.push_back(vertex.offset);
  }
  py::dict result;
  result["box"] = line<double>(std::vector<double>{made.box.x, made.box.y, made.box.z});
  result["vertex_points"] = line<std::int32_t>(std::move(points));
  result["vertex_offsets"] = rows<std::int8_t>(std::move(offsets));
  std::vector<std::array<double, 3>> positions;
  for (const Point3& p : made.positions) positions.push_back({p.x, p.y, p.z});
  result["vertices"] = rows<double>(std::move(positions));
  result["boundary"] = rows<std::int32_t>(periodic_boundary(made));
  result["simplices"] = rows<std::int32_t>(std::move(made.simplices));
  result["neighbors"] = rows<std::int32_t>(std::move(made.neighbors));
  result["duplicates"] = rows<std::int32_t>(std::move(made.duplicates));
  result["isolated"] = line<std::int32_t>(std::move(made.isolated));
  return result;
}

py::dict periodic_solid_of(const Doubles& points, const Box& box, double alpha, unsigned threads,
                           const py::object& progress) {
  const auto input = points3_of(points, "points");
  return arrays_of(watched(input.size(), progress, [&](Watch& watch) {
    return periodic_solid(input, sides_of(box), alpha, {.threads = threads, .progress = watch.progress()});
  }));
}

/// Returns the radius that `choice` chooses from all tetrahedra. Requires: the rule is auto or min.
double periodic_alpha_of(const Doubles& points, const Box& box, const AlphaChoice& choice, unsigned threads,
                         const py::object& progress) {
  const auto input = points3_of(points, "points");
  return watched(input.size(), progress, [&](Watch& watch) {
    const PeriodicSolid all = periodic_solid(input, sides_of(box), std::numeric_limits<double>::infinity(),
                                             {.threads = threads, .progress = watch.progress()});
    const std::vector<double> radii = circumradii(all.positions, all.simplices, threads);
    return choose_solid_alpha(choice, input, without_offsets(all), radii, {}, threads).alpha;
  });
}

using Part = std::tuple<std::size_t, Indices, double, double, unsigned, std::optional<double>>;
std::vector<Part> parts_of(std::vector<PeriodicPart> parts) {
  std::vector<Part> result;
  for (PeriodicPart& part : parts)
    result.emplace_back(part.tetrahedra, line<std::int32_t>(std::move(part.points)), part.volume, part.area,
                        part.dimension, part.outside_balls);
  return result;
}

/// Triangulates the points, and returns the topology of the complex at `alpha`.
py::dict periodic_topology_of(const Doubles& points, const Box& box, double alpha, bool full) {
  const auto input = points3_of(points, "points");
  PeriodicTopology made = watched(input.size(), py::none(), [&](Watch& watch) {
    const GoOn go_on = watch.until_stopped();
    const PeriodicSolid all =
        periodic_solid(input, sides_of(box), std::numeric_limits<double>::infinity(), {.progress = watch.progress()});
    return periodic_topology(all, circumradii(all.positions, all.simplices, 0, go_on), alpha,
                             full ? ComplexKind::full : ComplexKind::solid, 0, go_on);
  });
  py::dict result;
  result["betti"] = py::make_tuple(made.betti[0], made.betti[1], made.betti[2], made.betti[3]);
  result["volume"] = made.volume;
  result["area"] = made.area;
  result["solid_components"] = parts_of(std::move(made.solid_components));
  result["voids"] = parts_of(std::move(made.voids));
  return result;
}

}  // namespace

void bind_periodic_solid(py::module_& module) {
  using py::arg;
  module.def("periodic_solid", &periodic_solid_of, as_is("points"), arg("box"), arg("alpha"), arg("threads"),
             arg("progress"));
  module.def("periodic_alpha", &periodic_alpha_of, as_is("points"), arg("box"), arg("choice"), arg("threads"),
             arg("progress"));
  module.def("periodic_topology", &periodic_topology_of, as_is("points"), arg("box"), arg("alpha"), arg("full"));
}

}  // namespace rbpa::python
