#include "rbpa/space/surface/surface.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/failure.h"
#include "io/formats.h"
#include "io/mesh/ply_fields.h"
#include "io/mesh/vertices_of_points.h"
#include "io/mesh/write_mesh.h"
#include "io/number.h"
#include "python/file_errors.h"
#include "python/mesh.h"
#include "python/module.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/repair/reconstruct.h"
#include "rbpa/space/repair/watertight.h"
#include "rbpa/space/simplify/decimate.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/outer_shells.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/surface_mesh.h"
#include "rbpa/space/surface/surface_of.h"

namespace rbpa::python {
namespace {

using Flags = py::array_t<std::uint8_t, py::array::c_style>;

/// Returns the sides without a neighbor, as pairs of corners with the triangle on the left.
std::vector<std::array<std::uint32_t, 2>> boundary_of(const Surface& surface) {
  std::vector<std::array<std::uint32_t, 2>> sides;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (surface.neighbors[t][k] == Surface::none)
        sides.push_back({surface.triangles[t][(k + 1) % 3], surface.triangles[t][(k + 2) % 3]});
  return sides;
}

/// Returns triangles, neighbors and boundary of a surface as arrays, and moves them out of `made`.
py::dict as_dict(Surface& made) {
  std::vector<std::array<std::uint32_t, 2>> boundary;
  {
    const py::gil_scoped_release unlocked;
    boundary = boundary_of(made);
  }
  py::dict result;
  result["triangles"] = rows<std::int32_t>(std::move(made.triangles));
  result["neighbors"] = rows<std::int32_t>(std::move(made.neighbors));
  result["boundary"] = rows<std::int32_t>(std::move(boundary));
  return result;
}

/// Returns the arrays of a surface with filled holes, and for each triangle whether it is new. Moves the arrays of the
/// surface out of `made`.
py::dict as_dict(FilledSurface& made) {
  py::dict result = as_dict(made.surface);
  result["is_new"] = line<std::uint8_t>(std::vector<std::uint8_t>(made.is_new.begin(), made.is_new.end()));
  return result;
}

/// Returns the surface of points and its radii. Uses `normals` if given; otherwise estimates normals and returns them
/// as well if `estimates`, or uses no normals.
py::dict reconstructed(const Doubles& points, const MaybeDoubles& normals, bool estimates, const Doubles& radii,
                       double max_radius, unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  const auto vectors = points3_of(normals, "normals");
  const std::span<const double> wanted = line_of(radii);
  Reconstruction made = watched(input.size(), progress, [&](Watch& watch) {
    return reconstruct({input.begin(), input.end()}, {.normals = {vectors.begin(), vectors.end()},
                                                      .source = normals     ? NormalSource::given
                                                                : estimates ? NormalSource::estimate
                                                                            : NormalSource::none,
                                                      .radii = {wanted.begin(), wanted.end()},
                                                      .max_radius = max_radius,
                                                      .threads = threads,
                                                      .progress = watch.progress()});
  });
  static_assert(static_cast<std::uint32_t>(-1) == Surface::none);
  made.surface.levels.resize(made.surface.triangles.size());  // levels are empty for one radius; fills them with 0
  py::dict result = as_dict(made.surface);
  result["levels"] = line<std::int32_t>(std::move(made.surface.levels));
  result["duplicates"] = rows<std::int32_t>(std::move(made.surface.duplicates));
  result["radii"] = line<double>(std::move(made.radii));
  if (estimates) result["normals"] = rows<double>(std::move(made.normals));
  return result;
}

/// Returns the user's triangles as a surface. Entry `given` of the dict has the number of each triangle in `triangles`.
py::dict surface_of_triangles(const Doubles& points, const Indices& triangles) {
  const auto input = points3_of(points, "points");
  const auto rows_given = triples_of(triangles, "triangles");
  SurfaceOfTriangles made =
      watched(rows_given.size(), py::none(), [&](Watch&) { return surface_of(input, rows_given); });
  py::dict result = as_dict(made);
  result["levels"] = line<std::int32_t>(std::vector<std::uint32_t>(made.given.size()));
  result["duplicates"] = rows<std::int32_t>(std::move(made.duplicates));
  result["given"] = line<std::int32_t>(std::move(made.given));
  return result;
}

/// Views of the triangles and neighbors of a surface, which can be copied without Python's lock.
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

/// Returns the component of each triangle, and the measures of each component.
py::dict components_of(const Doubles& points, const Indices& triangles, const Indices& neighbors) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  SurfaceComponents found = watched(links.triangles.size(), py::none(), [&](Watch& watch) {
    return surface_components(input, of_links(links), watch.until_stopped());
  });
  py::dict result;
  result["number"] = line<std::int32_t>(std::move(found.number));
  result["area"] = column<double>(found.all, &SurfaceComponent::area);
  result["volume"] = column<double>(found.all, &SurfaceComponent::volume);
  result["boundary_curves"] = column<std::int64_t>(found.all, &SurfaceComponent::boundary_curves);
  result["box"] = column<double>(found.all, [](const SurfaceComponent& one) { return std::array{one.low, one.high}; });
  return result;
}

/// Returns for each component whether it passes all tests: is one of the `largest` largest, has the least number of
/// triangles and the least area, and, if `radius` is given, is an outer shell.
std::vector<bool> kept_of(const Doubles& points, const Indices& triangles, const Indices& neighbors,
                          std::optional<double> radius, std::optional<std::size_t> largest, std::size_t min_triangles,
                          double min_area) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  return watched(links.triangles.size(), py::none(), [&](Watch& watch) {
    const Surface surface = of_links(links);
    const GoOn go_on = watch.until_stopped();
    const SurfaceComponents components = surface_components(input, surface, go_on);
    std::vector<bool> outer;
    if (radius) outer = outer_shells(input, *radius, surface, components, go_on);
    return choose_components(components, outer,
                             {.shell = radius ? ShellChoice::outer : ShellChoice::all,
                              .max_components = largest,
                              .min_triangles = min_triangles,
                              .min_area = min_area});
  });
}

/// Fills holes that have at most `most_edges` edges and at most the length `most_length`; if `rims`, fills rims as
/// well.
py::dict filled(const Doubles& points, const Indices& triangles, const Indices& neighbors, std::size_t most_edges,
                double most_length, bool rims, unsigned threads) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  FilledSurface made = watched(long_work, py::none(), [&](Watch& watch) {
    const HoleChoice choice = {.most_edges = most_edges, .most_length = most_length, .rims = rims};
    return fill_holes(input, of_links(links), choice, {.threads = threads, .progress = watch.progress()});
  });
  return as_dict(made);
}

/// Refines the new triangles. Returns the surface, and the added points with their normals and the points around them.
py::dict refined(const Doubles& points, const MaybeDoubles& normals, const Indices& triangles, const Indices& neighbors,
                 const Flags& is_new, unsigned threads, const py::object& progress) {
  const auto input = points3_of(points, "points");
  const auto vectors = points3_of(normals, "normals");
  const Links links(triangles, neighbors);
  require_shape(is_new.ndim() == 1, is_new, "is_new", "(m,)");
  FilledSurface made;
  made.is_new.assign(is_new.data(), is_new.data() + is_new.shape(0));
  std::vector<Point3> further;
  AddedPoints added = watched(long_work, progress, [&](Watch& watch) {
    made.surface = of_links(links);
    AddedPoints result = refine_filling(input, made, {.threads = threads, .progress = watch.progress()});
    if (!vectors.empty()) further = normals_between(vectors, result.between);
    return result;
  });
  py::dict result = as_dict(made);
  result["points"] = rows<double>(std::move(added.points));
  result["normals"] = rows<double>(std::move(further));
  result["between"] = rows<std::int32_t>(std::move(added.between));
  return result;
}

/// Returns the numbers of open curves and of crossing pairs, with their places; an empty text if there are none.
std::string defects_of(const WatertightSurface& made) {
  if (made.open.empty() && made.crossing.empty()) return {};
  std::string text = app::counted(made.open.size(), "boundary curve");
  if (!made.open.empty()) {
    const auto longest = std::max_element(made.open.begin(), made.open.end(),
                                          [](const Hole& a, const Hole& b) { return a.length < b.length; });
    text += ", the longest of length " + app::rounded(longest->length, 6) + " at point " +
            std::to_string(longest->edges.front().from) + ",";
  }
  text += " and " + app::counted(made.crossing.size(), "pair") + " of triangles that cross";
  if (!made.crossing.empty())
    text += ", the first at point " + std::to_string(made.surface.triangles[made.crossing.front().first][0]);
  return text;
}

/// Makes the surface watertight. Returns the watertight surface, for each given triangle whether it is kept, and the
/// remaining defects.
py::dict watertight(const Doubles& points, const Indices& triangles, const Indices& neighbors, unsigned threads) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  WatertightSurface made = watched(long_work, py::none(), [&](Watch& watch) {
    return make_watertight(input, of_links(links), {}, {.threads = threads, .progress = watch.progress()});
  });
  const std::string defects = defects_of(made);
  py::dict result = as_dict(made);
  result["defects"] = defects;
  result["kept"] = line<std::uint8_t>(std::vector<std::uint8_t>(made.kept.begin(), made.kept.end()));
  return result;
}

/// Throws InvalidInput if rounding to single precision makes triangles lose their area or vertices coincide.
void require_kept(app::Format format, const app::SpaceMesh& mesh, const std::string& path) {
  std::string why = app::why_not_kept(app::single_positions(format, mesh.vertices, mesh.triangles, mesh.shift, path),
                                      format, mesh.vertices, mesh.triangles, path);
  if (why.empty()) return;
  constexpr std::string_view option = "--shift auto";
  if (const std::size_t at = why.find(option); at != std::string::npos)
    why.replace(at, option.size(), "shift=\"auto\"");
  throw InvalidInput("save: " + why);
}

/// Returns a field as a column. `values` are an array of numbers, or a list of texts.
app::PointColumn column_of(const std::string& name, const py::object& values) {
  app::PointColumn column{.name = name};
  if (py::isinstance<py::list>(values)) {
    column.type = app::Scalar::int32;
    column.is_text = true;
    for (const py::handle text : values) column.append(column.number_of(py::cast<std::string>(text)));
    return column;
  }
  const auto array = py::cast<py::array>(values);
  const auto type = app::scalar_of(std::string(1, array.dtype().kind()), std::to_string(array.itemsize()));
  if (!type) throw InvalidInput("fields: found a type of " + app::in_quotes(name) + " that no mesh file has");
  column.type = *type;
  const auto* const bytes = static_cast<const char*>(array.data());
  column.bytes.assign(bytes, bytes + array.nbytes());
  return column;
}

/// The colors of points, and the fields by name, in the form of column_of().
using MaybeColors = std::optional<py::array_t<std::uint8_t, py::array::c_style>>;
using Fields = std::vector<std::pair<std::string, py::object>>;

/// Writes a mesh file in the format of the ending of `name`. If `manifold`, or for .glb, vertices are fans; otherwise,
/// and for .npy, vertices are the points.
void saved(const py::bytes& name, const Doubles& points, const MaybeDoubles& normals, const MaybeColors& colors,
           const Fields& fields, const Indices& triangles, const Indices& neighbors, bool manifold,
           const std::optional<std::string>& shift) {
  const std::string path = name;
  const auto input = points3_of(points, "points");
  const auto vectors = points3_of(normals, "normals");
  const Links links(triangles, neighbors);
  const std::optional<app::Format> format = app::find_format(app::Use::boundary, app::ending(path));
  if (!format)
    throw InvalidInput("save: found the ending " + app::in_quotes(app::ending(path)) + ", expected one of " +
                       app::endings(app::Use::boundary));
  std::vector<app::PointColumn> columns;
  for (const auto& [field, values] : fields) columns.push_back(column_of(field, values));
  for (const app::PointColumn& column : columns)
    if (*format == app::Format::ply && !app::ply_type(column))
      throw InvalidInput("fields: found integers beyond 2^53 in " + app::in_quotes(column.name) +
                         ", expected numbers that PLY has (.vtu has them; fields= chooses others)");
  with_file_errors([&] {
    return watched(links.triangles.size(), py::none(), [&](Watch& watch) {
      app::SpaceMesh mesh{.vertices = input, .triangles = links.triangles, .normals = vectors, .fields = {columns}};
      if (colors) mesh.colors = {reinterpret_cast<const std::array<std::uint8_t, 3>*>(colors->data()), input.size()};
      if (shift) mesh.shift = app::parse_shift("shift", *shift);
      if (app::has_single_precision(*format)) require_kept(*format, mesh, path);
      SplitFans fans;
      std::optional<app::VerticesOfPoints> own;
      if (*format == app::Format::glb || (manifold && *format != app::Format::npy)) {
        fans = split_fans(of_links(links), watch.until_stopped());
        own.emplace(mesh, fans.triangles, fans.point, true);
        mesh = own->mesh();
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

/// Decimates the surface, and returns its arrays. Entry `given` has the number of each triangle before the decimation.
py::dict decimated(const Doubles& points, const Indices& triangles, const Indices& neighbors, std::size_t faces,
                   std::optional<double> error, bool no_crossings, bool measured, const py::object& progress) {
  const auto input = points3_of(points, "points");
  const Links links(triangles, neighbors);
  DecimatedSurface made = watched(links.triangles.size(), progress, [&](Watch& watch) {
    const OnProgress report = watch.progress();
    return decimate(input, of_links(links),
                    {.faces = faces,
                     .error = error,
                     .measured = measured,
                     .no_crossings = no_crossings,
                     .go_on = go_on_of(report, input.size(), links.triangles.size())});
  });
  py::dict result = as_dict(made);
  result["given"] = line<std::int32_t>(std::move(made.given));
  result["distance"] = made.counts.distance;
  return result;
}

/// Builds the halfedge mesh of a surface in `mesh`, which is empty: face i is triangle i, glued to its neighbors.
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
  module.def("reconstruct", &reconstructed, as_is("points"), as_is("normals"), arg("estimates"), as_is("radii"),
             arg("max_radius"), arg("threads"), arg("progress"));
  module.def("surface_of", &surface_of_triangles, as_is("points"), as_is("triangles"));
  module.def("surface_components", &components_of, as_is("points"), as_is("triangles"), as_is("neighbors"));
  module.def("choose_components", &kept_of, as_is("points"), as_is("triangles"), as_is("neighbors"), arg("radius"),
             arg("largest"), arg("min_triangles"), arg("min_area"));
  module.def("fill_holes", &filled, as_is("points"), as_is("triangles"), as_is("neighbors"), arg("most_edges"),
             arg("most_length"), arg("rims"), arg("threads"));
  module.def("make_watertight", &watertight, as_is("points"), as_is("triangles"), as_is("neighbors"), arg("threads"));
  module.def("refine_filling", &refined, as_is("points"), as_is("normals"), as_is("triangles"), as_is("neighbors"),
             as_is("is_new"), arg("threads"), arg("progress"));
  module.def("decimate_surface", &decimated, as_is("points"), as_is("triangles"), as_is("neighbors"), arg("faces"),
             arg("error"), arg("no_crossings"), arg("measured"), arg("progress"));
  module.def("save_surface", &saved, arg("path"), as_is("points"), as_is("normals"), as_is("colors"), arg("fields"),
             as_is("triangles"), as_is("neighbors"), arg("manifold"), arg("shift"));
  module.def("surface_mesh", &mesh_of, arg("mesh"), as_is("points"), as_is("triangles"), as_is("neighbors"));
}

}  // namespace rbpa::python
