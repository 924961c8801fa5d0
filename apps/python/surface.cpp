#include "rbpa/surface.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/mesh/write_mesh.h"
#include "io/values_at.h"
#include "python/arrays.h"
#include "python/file_errors.h"
#include "python/mesh.h"
#include "python/module.h"
#include "python/watched.h"
#include "rbpa/auto_radii.h"
#include "rbpa/close_surface.h"
#include "rbpa/crossing_triangles.h"
#include "rbpa/curve_kinds.h"
#include "rbpa/estimate_normals.h"
#include "rbpa/fill_holes.h"
#include "rbpa/holes.h"
#include "rbpa/outer_shells.h"
#include "rbpa/scale_space.h"
#include "rbpa/split_fans.h"
#include "rbpa/surface_components.h"
#include "rbpa/surface_levels.h"
#include "rbpa/surface_mesh.h"
#include "rbpa/unused.h"

namespace rbpa::python {
namespace {

using MaybeDoubles = std::optional<Doubles>;
using Causes = py::array_t<std::uint8_t, py::array::c_style>;

std::span<const double> numbers_of(const Doubles& array) {
  if (array.ndim() != 1) throw py::value_error("radii: expected an array of shape (k,)");
  return {array.data(), static_cast<std::size_t>(array.shape(0))};
}

/// What surfaces are made of. Without normals they are the exposed triangles of one radius.
struct Input {
  std::span<const Point3> points, normals;
  std::span<const double> radii;
  bool has_normals;

  Input(const Doubles& given_points, const MaybeDoubles& given_normals, const Doubles& given_radii)
      : points(points3_of(given_points, "points")),
        normals(given_normals ? points3_of(*given_normals, "normals") : std::span<const Point3>()),
        radii(numbers_of(given_radii)),
        has_normals(given_normals.has_value()) {
    if (!has_normals && radii.size() != 1) throw py::value_error("radii: expected one, without normals");
  }
};

/// Normals, and how sure each is.
std::tuple<Doubles, Doubles> estimated(const Doubles& points, std::size_t neighbors, const MaybeDoubles& viewpoints,
                                       unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  const auto from = viewpoints ? points3_of(*viewpoints, "viewpoint") : std::span<const Point3>();
  EstimatedNormals made = watched(input.size(), progress, [&](Watch& watch) {
    return estimate_normals_and_certainty(
        input, {.neighbors = neighbors, .viewpoints = from, .threads = threads, .progress = watch.progress()});
  });
  return {rows<double>(std::move(made.normals)), line<double>(std::move(made.certainty))};
}

/// The moved points, and by how many steps.
std::tuple<Doubles, std::size_t> moved(const Doubles& points, std::size_t steps, std::size_t neighbors,
                                       unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  ScaleSpace made = watched(input.size(), progress, [&](Watch& watch) {
    return scale_space(input,
                       {.steps = steps, .neighbors = neighbors, .threads = threads, .progress = watch.progress()});
  });
  return {rows<double>(std::move(made.points)), made.steps};
}

Doubles chosen_radii(const Doubles& points, unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  return line<double>(watched(input.size(), progress, [&](Watch& watch) {
    return auto_radii(input, {.threads = threads, .progress = watch.progress()});
  }));
}

/// The sides without a neighbour, from corner to corner, the triangle on the left.
std::vector<std::array<std::uint32_t, 2>> boundary_of(const Surface& surface) {
  std::vector<std::array<std::uint32_t, 2>> sides;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (surface.neighbors[t][k] == Surface::none)
        sides.push_back({surface.triangles[t][(k + 1) % 3], surface.triangles[t][(k + 2) % 3]});
  return sides;
}

/// Columns of a surface, and what is filled in it: of each triangle whether it is new, of each curve its outcome.
py::dict as_dict(Surface made, std::vector<std::array<std::uint32_t, 2>> boundary, const std::vector<bool>& is_new,
                 const std::vector<HoleFill>& holes, std::size_t given_up) {
  py::dict result;
  result["triangles"] = rows<std::int32_t>(std::move(made.triangles));
  result["neighbors"] = rows<std::int32_t>(std::move(made.neighbors));
  result["boundary"] = rows<std::int32_t>(std::move(boundary));
  result["is_new"] = line<std::uint8_t>(std::vector<std::uint8_t>(is_new.begin(), is_new.end()));
  std::vector<std::uint8_t> outcomes;
  for (const HoleFill& hole : holes) outcomes.push_back(static_cast<std::uint8_t>(hole.outcome));
  result["outcomes"] = line<std::uint8_t>(std::move(outcomes));
  result["given_up"] = given_up;
  return result;
}

py::dict surface_of(const Doubles& points, const MaybeDoubles& normals, const Doubles& radii, unsigned threads,
                    const py::object& progress) {
  const Input input(points, normals, radii);
  std::vector<std::array<std::uint32_t, 2>> boundary;
  Surface made = watched(input.points.size(), progress, [&](Watch& watch) {
    const SurfaceOptions options = {.threads = threads, .progress = watch.progress()};
    Surface found = input.has_normals ? surface(input.points, input.normals, input.radii, options)
                                      : exposed_triangles(input.points, input.radii.front(), options);
    boundary = boundary_of(found);
    return found;
  });
  static_assert(static_cast<std::uint32_t>(-1) == Surface::none);
  made.levels.resize(made.triangles.size());  // of one radius there are none: all are of the first
  py::dict result;
  result["triangles"] = rows<std::int32_t>(std::move(made.triangles));
  result["neighbors"] = rows<std::int32_t>(std::move(made.neighbors));
  result["levels"] = line<std::int32_t>(std::move(made.levels));
  result["boundary"] = rows<std::int32_t>(std::move(boundary));
  result["duplicates"] = rows<std::int32_t>(std::move(made.duplicates));
  return result;
}

/// What surface_of() gave, as the library had it.
Surface surface_again(const Input& input, const Indices& triangles, const Indices& neighbors, const Indices& levels,
                      const Indices& duplicates) {
  Surface made;
  const auto corners = triples_of(triangles, "triangles"), others = triples_of(neighbors, "neighbors");
  if (others.size() != corners.size() || levels.ndim() != 1 ||
      static_cast<std::size_t>(levels.shape(0)) != corners.size())
    throw py::value_error("triangles, neighbors and levels: expected arrays of one length");
  if (duplicates.ndim() != 2 || duplicates.shape(1) != 2)
    throw py::value_error("duplicates: expected an array of shape (n, 2)");
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

/// All sides of all boundary curves column by column, and where each curve begins.
py::dict holes_of(const Doubles& points, const Doubles& normals, const Doubles& radii, const Indices& triangles,
                  const Indices& neighbors, const Indices& levels, const Indices& duplicates, unsigned threads) {
  const Input input(points, normals, radii);
  const Surface made = surface_again(input, triangles, neighbors, levels, duplicates);
  std::vector<std::int64_t> begin = {0};
  std::vector<double> lengths;
  std::vector<std::uint8_t> kinds;
  std::vector<RimEdge> all;
  watched(input.points.size(), py::none(), [&](Watch& watch) {
    const SurfaceOptions options = {.threads = threads, .progress = watch.progress()};
    const std::vector<Hole> found = holes(input.points, input.normals, input.radii, made, options);
    for (const CurveKind kind : curve_kinds(input.points, surface_components(input.points, made), found))
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

/// Points, and the number of the cause of each.
std::tuple<Indices, Causes> unused_of(const Doubles& points, const MaybeDoubles& normals, const Doubles& radii,
                                      const Indices& triangles, const Indices& neighbors, const Indices& levels,
                                      const Indices& duplicates, unsigned threads) {
  const Input input(points, normals, radii);
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

/// Triangles and neighbours of a surface, which are copied without Python's lock.
struct Links {
  std::span<const Triple> triangles, neighbors;

  Links(const Indices& of_triangles, const Indices& of_neighbors)
      : triangles(triples_of(of_triangles, "triangles")), neighbors(triples_of(of_neighbors, "neighbors")) {}
};

Surface of_links(const Links& links) {
  Surface surface;
  surface.triangles.assign(links.triangles.begin(), links.triangles.end());
  surface.neighbors.assign(links.neighbors.begin(), links.neighbors.end());
  return surface;
}

/// The number of its component for each triangle, and a row of numbers for each component.
py::dict components_of(const Doubles& points, const Indices& triangles, const Indices& neighbors) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  SurfaceComponents found =
      watched(links.triangles.size(), py::none(), [&](Watch&) { return surface_components(input, of_links(links)); });
  std::vector<double> areas, volumes;
  std::vector<std::int64_t> curves;
  std::vector<std::array<Point3, 2>> boxes;
  for (const SurfaceComponent& component : found.all) {
    areas.push_back(component.area);
    volumes.push_back(component.volume);
    curves.push_back(static_cast<std::int64_t>(component.boundary_curves));
    boxes.push_back({component.low, component.high});
  }
  py::dict result;
  result["number"] = line<std::int32_t>(std::move(found.number));
  result["area"] = line<double>(std::move(areas));
  result["volume"] = line<double>(std::move(volumes));
  result["boundary_curves"] = line<std::int64_t>(std::move(curves));
  result["box"] = rows<double>(std::move(boxes));
  return result;
}

/// Of each component, whether it is an outer shell.
std::vector<bool> outer_of(const Doubles& points, double radius, const Indices& triangles, const Indices& neighbors) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  return watched(links.triangles.size(), py::none(), [&](Watch&) {
    const Surface shells = of_links(links);
    return outer_shells(input, radius, shells, surface_components(input, shells));
  });
}

/// The holes of at most so many edges and such a length filled; of each curve that is, its outcome.
py::dict filled(const Doubles& points, const Indices& triangles, const Indices& neighbors, std::size_t most_edges,
                double most_length, bool rims, unsigned threads) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  std::vector<std::array<std::uint32_t, 2>> boundary;
  FilledSurface made = watched(links.triangles.size(), py::none(), [&](Watch& watch) {
    const Surface open = indexable_surface(of_links(links));
    const std::vector<Hole> curves = surface_curves(input, open);
    const std::vector<CurveKind> kinds = curve_kinds(input, surface_components(input, open), curves);
    std::vector<Hole> chosen;
    for (std::size_t i = 0; i < curves.size(); ++i)
      if ((rims || kinds[i] == CurveKind::hole) && curves[i].edges.size() <= most_edges &&
          curves[i].length <= most_length)
        chosen.push_back(curves[i]);
    FilledSurface result = fill_holes(input, open, chosen, {.threads = threads, .progress = watch.progress()});
    boundary = boundary_of(result.surface);
    return result;
  });
  return as_dict(std::move(made.surface), std::move(boundary), made.is_new, made.holes, 0);
}

/// All holes and rims; and how many pairs of triangles cross, of the first thousand.
py::dict closed(const Doubles& points, const Indices& triangles, const Indices& neighbors, unsigned threads) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  std::vector<std::array<std::uint32_t, 2>> boundary;
  std::size_t curves = 0, crossing = 0;
  ClosedSurface made = watched(links.triangles.size(), py::none(), [&](Watch& watch) {
    const SurfaceOptions options = {.threads = threads, .progress = watch.progress()};
    ClosedSurface result = close_surface(input, indexable_surface(of_links(links)), options);
    boundary = boundary_of(result.surface);
    curves = surface_curves(input, result.surface).size();
    constexpr std::size_t most = 1000;
    crossing = crossing_triangles(input, result.surface.triangles, most, options).size();
    return result;
  });
  py::dict result = as_dict(std::move(made.surface), std::move(boundary), made.is_new, made.holes, made.given_up);
  result["kept"] = line<std::uint8_t>(std::vector<std::uint8_t>(made.kept.begin(), made.kept.end()));
  result["curves"] = curves;
  result["crossing"] = crossing;
  return result;
}

/// A mesh file by its ending; with a vertex for each fan, or the points as they are.
void saved(const py::bytes& name, const Doubles& points, const MaybeDoubles& normals, const Indices& triangles,
           const Indices& neighbors, bool manifold) {
  const std::string path = name;
  const auto input = points3_of(points, "points");
  const auto vectors = normals ? points3_of(*normals, "normals") : std::span<const Point3>();
  const Links links(triangles, neighbors);
  constexpr std::string_view formats = "ply, off, obj, stl, glb, vtu, npy";
  const std::optional<app::Format> format = app::find_format(app::Use::surface, app::ending(path));
  if (!format || *format == app::Format::png)
    throw InvalidInput("save: found the ending " + app::in_quotes(app::ending(path)) + ", expected one of " +
                       std::string(formats));
  with_file_errors([&] {
    return watched(links.triangles.size(), py::none(), [&](Watch&) {
      app::SpaceMesh mesh{.vertices = input, .triangles = links.triangles, .normals = vectors};
      SplitFans fans;
      std::vector<Point3> own_points, own_normals;
      if (*format == app::Format::glb || (manifold && *format != app::Format::npy)) {
        fans = split_fans(of_links(links));
        own_points = app::values_at(input, fans.point);
        own_normals = app::values_at(vectors, fans.point);
        mesh = {.vertices = own_points, .triangles = fans.triangles, .normals = own_normals, .points = fans.point};
      }
      app::OutputSet outputs;
      app::OutputFile& file = outputs.add(path);
      app::write_surface(file, *format, mesh);
      file.finish();
      outputs.publish();
      return 0;
    });
  });
}

/// Fills an empty mesh: face i is triangle i, glued where the surface is.
void mesh_of(Mesh& mesh, const Doubles& points, const Indices& triangles, const Indices& neighbors) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  mesh.changed();
  mesh.built_on = watched(links.triangles.size(), py::none(), [&](Watch&) {
    SurfaceMesh made = surface_mesh(input, of_links(links));
    mesh.kernel().take_links(made.mesh);
    return std::move(made.input_index);
  });
}

}  // namespace

void bind_surface(py::module_& module) {
  using py::arg;
  module.def("estimate_normals", &estimated, arg("points").noconvert(), arg("neighbors"), arg("viewpoints").noconvert(),
             arg("threads"), arg("progress"));
  module.def("scale_space", &moved, arg("points").noconvert(), arg("steps"), arg("neighbors"), arg("threads"),
             arg("progress"));
  module.def("auto_radii", &chosen_radii, arg("points").noconvert(), arg("threads"), arg("progress"));
  module.def("surface", &surface_of, arg("points").noconvert(), arg("normals").noconvert(), arg("radii").noconvert(),
             arg("threads"), arg("progress"));
  module.def("surface_holes", &holes_of, arg("points").noconvert(), arg("normals").noconvert(),
             arg("radii").noconvert(), arg("triangles").noconvert(), arg("neighbors").noconvert(),
             arg("levels").noconvert(), arg("duplicates").noconvert(), arg("threads"));
  module.def("surface_components", &components_of, arg("points").noconvert(), arg("triangles").noconvert(),
             arg("neighbors").noconvert());
  module.def("outer_shells", &outer_of, arg("points").noconvert(), arg("radius"), arg("triangles").noconvert(),
             arg("neighbors").noconvert());
  module.def("fill_holes", &filled, arg("points").noconvert(), arg("triangles").noconvert(),
             arg("neighbors").noconvert(), arg("most_edges"), arg("most_length"), arg("rims"), arg("threads"));
  module.def("close_surface", &closed, arg("points").noconvert(), arg("triangles").noconvert(),
             arg("neighbors").noconvert(), arg("threads"));
  module.def("save_surface", &saved, arg("path"), arg("points").noconvert(), arg("normals").noconvert(),
             arg("triangles").noconvert(), arg("neighbors").noconvert(), arg("manifold"));
  module.def("surface_mesh", &mesh_of, arg("mesh"), arg("points").noconvert(), arg("triangles").noconvert(),
             arg("neighbors").noconvert());
  module.def("surface_unused", &unused_of, arg("points").noconvert(), arg("normals").noconvert(),
             arg("radii").noconvert(), arg("triangles").noconvert(), arg("neighbors").noconvert(),
             arg("levels").noconvert(), arg("duplicates").noconvert(), arg("threads"));
}

}  // namespace rbpa::python
