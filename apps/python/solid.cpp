#include "rbpa/space/solid/solid.h"

#include <array>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "python/module.h"
#include "python/solid_again.h"
#include "rbpa/space/balls/dangling_faces.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/balls/union_of_balls.h"
#include "rbpa/space/persistence/choose_solid_alpha.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_radii.h"
#include "rbpa/space/solid/voids.h"

namespace rbpa::python {
namespace {

py::dict solid_of(const Doubles& points, double alpha, unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  Solid made = watched(input.size(), progress, [&](Watch& watch) {
    return solid(input, alpha, {.threads = threads, .progress = watch.progress()});
  });
  static_assert(static_cast<std::uint32_t>(-1) == Solid::none);
  py::dict result;
  result["simplices"] = rows<std::int32_t>(std::move(made.simplices));
  result["neighbors"] = rows<std::int32_t>(std::move(made.neighbors));
  result["duplicates"] = rows<std::int32_t>(std::move(made.duplicates));
  result["isolated"] = line<std::int32_t>(std::move(made.isolated));
  return result;
}

Doubles radii_of(const Doubles& points, const Indices& simplices, unsigned threads) {
  const auto input = points3_of(points, "points");
  return line<double>(watched(input.size(), py::none(), [&](Watch& watch) {
    return circumradii(input, quadruples_of(simplices, "simplices"), threads, watch.until_stopped());
  }));
}

/// Returns the radius that `choice` chooses. Requires: `simplices` are all tetrahedra of the points.
double choose_solid_alpha_of(const Doubles& points, const Indices& simplices, const Indices& neighbors,
                             const Doubles& radii, std::size_t distinct, const AlphaChoice& choice, unsigned threads) {
  const auto input = points3_of(points, "points");
  return watched(input.size(), py::none(), [&](Watch& watch) {
    Solid delaunay = solid_again(simplices, neighbors);
    delaunay.distinct = distinct;
    return choose_solid_alpha(choice, input, delaunay, line_of(radii), watch.until_stopped(), threads).alpha;
  });
}

/// Returns the tetrahedra with a circumradius of at most `alpha`, their neighbors, and the corners of other tetrahedra
/// that are in none of the returned ones.
py::dict within_of(const Indices& simplices, const Indices& neighbors, const Doubles& radii, double alpha) {
  Solid made = watched(static_cast<std::size_t>(radii.size()), py::none(),
                       [&](Watch&) { return within(solid_again(simplices, neighbors), line_of(radii), alpha); });
  py::dict result;
  result["simplices"] = rows<std::int32_t>(std::move(made.simplices));
  result["neighbors"] = rows<std::int32_t>(std::move(made.neighbors));
  result["isolated"] = line<std::int32_t>(std::move(made.isolated));
  return result;
}

std::pair<double, double> balls_of(const Doubles& points, double radius, unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  const BallUnion found = watched(input.size(), progress, [&](Watch& watch) {
    return union_of_balls(input, radius, {.threads = threads, .progress = watch.progress()});
  });
  return {found.volume, found.area};
}

/// Triangulates the points, and returns the dangling simplices of the full alpha complex.
std::tuple<Indices, Indices, Indices> dangling_of(const Doubles& points, double alpha) {
  const auto input = points3_of(points, "points");
  DanglingFaces found = watched(input.size(), py::none(), [&](Watch& watch) {
    const Solid delaunay = solid(input, std::numeric_limits<double>::infinity(), {.progress = watch.progress()});
    return dangling_faces(input, delaunay, circumradii(input, delaunay.simplices, 0, watch.until_stopped()), alpha);
  });
  return {rows<std::int32_t>(std::move(found.triangles)), rows<std::int32_t>(std::move(found.edges)),
          line<std::int32_t>(std::move(found.points))};
}

/// Returns the arguments of rbpa.SolidVoid for each void.
py::list as_list(std::vector<SolidVoid> voids) {
  py::list list;
  for (SolidVoid& hollow : voids)
    list.append(py::make_tuple(hollow.volume, hollow.area, rows<double>(std::vector<Point3>{hollow.low, hollow.high}),
                               hollow.islands, line<std::int32_t>(std::move(hollow.triangles)),
                               line<std::int32_t>(std::move(hollow.points)), hollow.outside_balls));
  return list;
}

/// Returns the boundary and the voids of a solid.
py::dict voids_of(const Doubles& points, const Indices& simplices, const Indices& neighbors) {
  const auto input = points3_of(points, "points");
  struct Made {
    SolidBoundary boundary;
    BoundaryMeasures measures;
    Voids voids;
  };
  Made made = watched(input.size(), py::none(), [&](Watch&) {
    const Solid again = solid_again(simplices, neighbors);
    Made all{.boundary = solid_boundary(again), .measures = {}, .voids = {}};
    all.measures = measure(input, all.boundary.surface);
    all.voids = voids(input, again, all.boundary);
    return all;
  });
  const SolidCounts& counts = made.voids.counts;
  py::dict result;
  result["triangles"] = rows<std::int32_t>(std::move(made.boundary.surface.triangles));
  result["neighbors"] = rows<std::int32_t>(std::move(made.boundary.surface.neighbors));
  result["tetrahedra"] = line<std::int32_t>(std::move(made.boundary.tetrahedra));
  result["betti"] = py::make_tuple(counts.components, counts.tunnels, counts.voids);
  result["solid_components"] = counts.solid_components;
  result["volume"] = made.measures.volume;
  result["area"] = made.measures.area;
  result["voids"] = as_list(std::move(made.voids.all));
  return result;
}

/// Triangulates the points, and returns the Betti numbers and the voids of the full alpha complex.
py::dict full_of(const Doubles& points, double alpha) {
  const auto input = points3_of(points, "points");
  FullTopology made = watched(input.size(), py::none(), [&](Watch& watch) {
    const GoOn go_on = watch.until_stopped();
    const Solid delaunay = solid(input, std::numeric_limits<double>::infinity(), {.progress = watch.progress()});
    return full_topology(input, delaunay, circumradii(input, delaunay.simplices, 0, go_on), alpha, 0, go_on);
  });
  py::dict result;
  result["betti"] = py::make_tuple(made.counts.components, made.counts.tunnels, made.counts.voids);
  result["triangles"] = rows<std::int32_t>(std::move(made.voids.boundary.triangles));
  result["voids"] = as_list(std::move(made.voids.all));
  return result;
}

}  // namespace

void bind_solid(py::module_& module) {
  using py::arg;
  module.def("solid", &solid_of, as_is("points"), arg("alpha"), arg("threads"), arg("progress"));
  module.def("circumradii", &radii_of, as_is("points"), as_is("simplices"), arg("threads"));
  module.def("choose_solid_alpha", &choose_solid_alpha_of, as_is("points"), as_is("simplices"), as_is("neighbors"),
             as_is("radii"), arg("distinct"), arg("choice"), arg("threads"));
  module.def("solid_within", &within_of, as_is("simplices"), as_is("neighbors"), as_is("radii"), arg("alpha"));
  module.def("union_of_balls", &balls_of, as_is("points"), arg("radius"), arg("threads"), arg("progress"));
  module.def("solid_dangling", &dangling_of, as_is("points"), arg("alpha"));
  module.def("solid_full", &full_of, as_is("points"), arg("alpha"));
  module.def("solid_voids", &voids_of, as_is("points"), as_is("simplices"), as_is("neighbors"));
}

}  // namespace rbpa::python
