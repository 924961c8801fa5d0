#include "python/mesh.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/handle/separate_fans.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/count.h"
#include "meshops/topology/homology.h"
#include "meshops/topology/report.h"
#include "python/module.h"
#include "python/soup.h"
#include "rbpa/space/simplify/decimate_mesh.h"
#include "rbpa/space/simplify/progressive_mesh.h"
#include "rbpa/space/simplify/remesh.h"
#include "rbpa/space/simplify/subdivide.h"

namespace rbpa::python {
namespace {

using meshops::Edge;
using meshops::Face;
using meshops::Halfedge;
using meshops::Vertex;

template <typename Handle>
std::vector<std::uint32_t> numbers(const std::vector<Handle>& handles) {
  std::vector<std::uint32_t> all;
  all.reserve(handles.size());
  for (const Handle h : handles) all.push_back(static_cast<std::uint32_t>(h.idx()));
  return all;
}

std::unique_ptr<Mesh> make_mesh(const Indices& corners, const Begins& begin, std::size_t points) {
  auto mesh = std::make_unique<Mesh>();
  const meshops::PolygonSoup soup = soup_of(corners, begin, points);
  mesh->built_on = watched(soup.faces(), py::none(), [&](Watch& watch) {
    return meshops::build_mesh(mesh->changed(), soup, watch.until_stopped());
  });
  return mesh;
}

/// Returns `handle`. Throws ContractViolation unless its element exists in `mesh`.
template <typename Handle>
Handle live(const meshops::Connectivity& mesh, Handle handle, const char* kind) {
  if (!meshops::is_live(mesh, handle))
    throw meshops::ContractViolation(std::string(kind) + ' ' + std::to_string(handle.idx()) +
                                     " does not exist or is deleted");
  return handle;
}

// Bind stateless functions as function pointers, so that pybind11 compiles each signature only once.
using Count = std::size_t (*)(const Mesh&);

template <typename ForEach>
Count counted(ForEach) {
  return [](const Mesh& m) {
    std::size_t count = 0;
    ForEach{}(m.seen(), [&](auto) { ++count; });
    return count;
  };
}

template <typename ForEach>
auto listed(ForEach) {
  return +[](const Mesh& m) {
    std::vector<std::uint32_t> all;
    ForEach{}(m.seen(), [&](auto handle) { all.push_back(static_cast<std::uint32_t>(handle.idx())); });
    return line<std::int32_t>(std::move(all));
  };
}

void bind_elements(py::class_<Mesh>& mesh) {
  const auto bind = [&]<typename ForEach>(const std::string& one, const std::string& many, ForEach for_each,
                                          Count bound, const std::string& note_on_count = {}) {
    mesh.def(many.c_str(), listed(for_each),
             ("Returns the " + many + " that are not deleted, ascending: an int32 array.").c_str());
    mesh.def_property_readonly(("n_" + many).c_str(), counted(for_each),
                               ("The number of " + many + " that are not deleted" + note_on_count + ".").c_str());
    mesh.def_property_readonly(
        (one + "_bound").c_str(), bound,
        ("One more than the largest " + one + " number, deleted ones included: the length of arrays by " + one + ".")
            .c_str());
  };
  bind(
      "vertex", "vertices", [](const auto& m, auto visit) { meshops::for_each_vertex(m, visit); },
      [](const Mesh& m) { return m.seen().n_vertices(); }, ", isolated ones included");
  bind(
      "edge", "edges", [](const auto& m, auto visit) { meshops::for_each_edge(m, visit); },
      [](const Mesh& m) { return m.seen().n_edges(); });
  bind(
      "face", "faces", [](const auto& m, auto visit) { meshops::for_each_face(m, visit); },
      [](const Mesh& m) { return m.seen().n_faces(); });
  mesh.def("halfedges", listed([](const auto& m, auto visit) { meshops::for_each_halfedge(m, visit); }),
           "Returns the halfedges that are not deleted, ascending: an int32 array. Edge e has 2 e and 2 e + 1.");
}

void bind_navigation(py::class_<Mesh>& mesh) {
  using py::arg;
  const auto of = [&]<typename From>(const char* name, const char* what, From) {
    mesh.def(
        name, +[](const Mesh& m, Halfedge h) { return From{}(m.seen(), live(m.seen(), h, "halfedge")); },
        arg("halfedge"), what);
  };
  of("from_vertex", "Returns the vertex where the halfedge starts.",
     [](const auto& m, Halfedge h) { return m.from_vertex_handle(h); });
  of("to_vertex", "Returns the vertex where the halfedge ends.",
     [](const auto& m, Halfedge h) { return m.to_vertex_handle(h); });
  of("next", "Returns the next halfedge around its face, or along the boundary.",
     [](const auto& m, Halfedge h) { return m.next_halfedge_handle(h); });
  of("prev", "Returns the previous halfedge around its face, or along the boundary.",
     [](const auto& m, Halfedge h) { return m.prev_halfedge_handle(h); });
  of("opposite", "Returns the other halfedge of its edge.",
     [](const auto& m, Halfedge h) { return m.opposite_halfedge_handle(h); });
  of("edge", "Returns the edge of the halfedge.", [](const auto& m, Halfedge h) { return m.edge_handle(h); });
  of("face", "Returns the face on the left of the halfedge, or None on the boundary.",
     [](const auto& m, Halfedge h) { return maybe(m.face_handle(h)); });
  of("is_boundary", "Returns whether the halfedge has no face on its left.",
     [](const auto& m, Halfedge h) { return m.is_boundary(h); });
  mesh.def(
          "halfedge_of_vertex",
          [](const Mesh& m, Vertex v) { return maybe(m.seen().halfedge_handle(live(m.seen(), v, "vertex"))); },
          arg("vertex"),
          "Returns a halfedge that starts at the vertex, on the boundary if possible; None if there is none.")
      .def(
          "halfedge_of_face", [](const Mesh& m, Face f) { return m.seen().halfedge_handle(live(m.seen(), f, "face")); },
          arg("face"), "Returns the first side of the face.")
      .def(
          "find_halfedge",
          [](const Mesh& m, Vertex a, Vertex b) {
            return maybe(Halfedge(m.seen().find_halfedge(live(m.seen(), a, "vertex"), live(m.seen(), b, "vertex"))));
          },
          arg("start"), arg("end"), "Returns a halfedge from one vertex to the other, or None.")
      .def(
          "polygons",
          [](const Mesh& m) {
            meshops::PolygonSoup soup = meshops::soup_of(m.seen());
            std::vector<std::int64_t> begin(soup.begin.begin(), soup.begin.end());
            return std::make_tuple(line<std::int32_t>(std::move(soup.corners)), line<std::int64_t>(std::move(begin)));
          },
          "Returns (corners, begin): the corners of all faces that are not deleted, one face after the other, and the "
          "begin of each face.")
      .def(
          "face_vertices",
          [](const Mesh& m, Face f) {
            std::vector<Vertex> corners;
            const Halfedge first = m.seen().halfedge_handle(live(m.seen(), f, "face"));
            Halfedge h = first;
            do corners.push_back(m.seen().from_vertex_handle(h));
            while ((h = m.seen().next_halfedge_handle(h)) != first);
            return line<std::int32_t>(numbers(corners));
          },
          arg("face"), "Returns the corners of the face in its direction, from its first side on: an int32 array.");
}

/// Returns all links of the mesh, for pickling.
py::tuple state_of(const Mesh& mesh) {
  const meshops::Connectivity& m = mesh.seen();
  std::vector<std::array<std::int32_t, 2>> vertices, faces;
  std::vector<std::array<std::int32_t, 5>> halfedges;
  for (int v = 0; v < int(m.n_vertices()); ++v)
    vertices.push_back({m.halfedge_handle(Vertex(v)).idx(), m.status(Vertex(v)).deleted() ? 1 : 0});
  for (int h = 0; h < int(m.n_halfedges()); ++h)
    halfedges.push_back({m.to_vertex_handle(Halfedge(h)).idx(), m.next_halfedge_handle(Halfedge(h)).idx(),
                         m.prev_halfedge_handle(Halfedge(h)).idx(), m.face_handle(Halfedge(h)).idx(),
                         m.status(m.edge_handle(Halfedge(h))).deleted() ? 1 : 0});
  for (int f = 0; f < int(m.n_faces()); ++f)
    faces.push_back({m.halfedge_handle(Face(f)).idx(), m.status(Face(f)).deleted() ? 1 : 0});
  return py::make_tuple(rows<std::int32_t>(std::move(vertices)), rows<std::int32_t>(std::move(halfedges)),
                        rows<std::int32_t>(std::move(faces)),
                        line<std::int32_t>(std::vector<std::uint32_t>(mesh.built_on)));
}

std::unique_ptr<Mesh> mesh_of(const Indices& vertices, const Indices& halfedges, const Indices& faces,
                              const Indices& built_on) {
  auto mesh = std::make_unique<Mesh>();
  MeshKernel& m = mesh->kernel();
  const auto v_at = vertices.unchecked<2>();
  const auto h_at = halfedges.unchecked<2>();
  const auto f_at = faces.unchecked<2>();
  meshops::require(h_at.shape(0) % 2 == 0, "mesh: found an odd number of halfedges, expected two for each edge");
  m.resize(static_cast<std::size_t>(v_at.shape(0)), static_cast<std::size_t>(h_at.shape(0) / 2),
           static_cast<std::size_t>(f_at.shape(0)));
  const auto in = [](int i, py::ssize_t count) {
    meshops::require(-1 <= i && i < count, "mesh: found a link to element ", i,
                     ", expected -1 or the number of an element of the mesh (pickle the mesh again)");
    return i;
  };
  for (int v = 0; v < v_at.shape(0); ++v) {
    m.set_halfedge_handle(Vertex(v), Halfedge(in(v_at(v, 0), h_at.shape(0))));
    m.status(Vertex(v)).set_deleted(v_at(v, 1) != 0);
  }
  for (int h = 0; h < h_at.shape(0); ++h) {
    m.set_vertex_handle(Halfedge(h), Vertex(in(h_at(h, 0), v_at.shape(0))));
    m.set_face_handle(Halfedge(h), Face(in(h_at(h, 3), f_at.shape(0))));
    m.status(m.edge_handle(Halfedge(h))).set_deleted(h_at(h, 4) != 0);
    m.status(Halfedge(h)).set_deleted(h_at(h, 4) != 0);
    if (in(h_at(h, 1), h_at.shape(0)) >= 0) m.set_next_halfedge_handle(Halfedge(h), Halfedge(h_at(h, 1)));
  }
  // Set prev links after all next links: setting the next link of a halfedge, even of a deleted one, also sets the prev
  // link of the next halfedge.
  for (int h = 0; h < h_at.shape(0); ++h)
    m.set_prev_halfedge_handle(Halfedge(h), Halfedge(in(h_at(h, 2), h_at.shape(0))));
  for (int f = 0; f < f_at.shape(0); ++f) {
    m.set_halfedge_handle(Face(f), Halfedge(in(f_at(f, 0), h_at.shape(0))));
    m.status(Face(f)).set_deleted(f_at(f, 1) != 0);
  }
  const auto on = built_on.unchecked<1>();
  for (py::ssize_t i = 0; i < on.shape(0); ++i) mesh->built_on.push_back(static_cast<std::uint32_t>(on(i)));
  for (const meshops::Defect& defect : meshops::validate(m))
    if (defect.kind != meshops::DefectKind::vertex_has_several_fans)
      throw meshops::ContractViolation("mesh: " + describe(defect));
  return mesh;
}

std::tuple<std::vector<Indices>, Indices> homology(Mesh& mesh, const std::optional<Doubles>& lengths) {
  std::vector<double> given;
  if (lengths) given.assign(lengths->data(), lengths->data() + lengths->size());
  const Mesh::Look look(mesh);
  const meshops::Homology found = watched(mesh.seen().n_faces(), py::none(), [&](Watch& watch) {
    return lengths ? meshops::homology(mesh.seen(), given, watch.until_stopped())
                   : meshops::homology(mesh.seen(), watch.until_stopped());
  });
  std::vector<Indices> loops;
  for (const meshops::Loop& loop : found.generators) loops.push_back(line<std::int32_t>(numbers(loop)));
  return {std::move(loops), line<std::int32_t>(numbers(found.cut_graph))};
}

meshops::TopologyReport report(Mesh& mesh, const std::optional<std::vector<std::uint32_t>>& point_of_vertex) {
  const std::vector<std::uint32_t> own, &points = point_of_vertex ? *point_of_vertex : own;
  const Mesh::Look look(mesh);
  return watched(mesh.seen().n_faces(), py::none(),
                 [&](Watch& watch) { return meshops::report(mesh.seen(), points, watch.until_stopped()); });
}

/// Calls change(copy, places, go_on) with a copy of the mesh, then replaces the mesh by the copy, so that a run that
/// ends early changes nothing. Returns the places of the vertices, and the result of change(). Passes `work` as
/// `points` to watched().
template <typename Change>
auto change_copy(Mesh& mesh, const Doubles& points, std::size_t work, const py::object& progress,
                 const Change& change) {
  const auto input = points3_of(points, "points");
  std::vector<Point3> places(input.begin(), input.end());
  MeshKernel copy = mesh.kernel();
  mesh.changed();
  const auto counts = [&] {
    const Mesh::Look look(mesh);
    const std::size_t given = copy.n_faces();
    return watched(work, progress, [&](Watch& watch) {
      const OnProgress report = watch.progress();
      return change(copy, places, go_on_of(report, places.size(), given));
    });
  }();
  mesh.changed();
  mesh.kernel() = std::move(copy);
  return std::pair(rows<double>(std::move(places)), counts);
}

auto decimate_copy(Mesh& mesh, const Doubles& points, std::size_t faces, std::optional<double> error, bool no_crossings,
                   bool measured, const py::object& progress) {
  const auto [places, counts] =
      change_copy(mesh, points, mesh.kernel().n_faces(), progress, [&](auto& copy, auto& moved, const GoOn& go_on) {
        return decimate(
            copy, moved,
            {.faces = faces, .error = error, .measured = measured, .no_crossings = no_crossings, .go_on = go_on});
      });
  return std::make_tuple(places, counts.given, counts.left, counts.collapses, counts.refused, counts.distance);
}

auto remesh_copy(Mesh& mesh, const Doubles& points, const Doubles& lengths, std::optional<double> error,
                 unsigned rounds, double sharp_angle, bool keep_boundary, const py::object& progress) {
  const std::span<const double> wanted(lengths.data(), static_cast<std::size_t>(lengths.size()));
  const auto [places, counts] =
      change_copy(mesh, points, long_work, progress, [&](auto& copy, auto& moved, const GoOn& go_on) {
        return remesh(static_cast<meshops::Connectivity&>(copy), moved,
                      {.length = *std::max_element(wanted.begin(), wanted.end()),
                       .lengths = lengths.ndim() == 0 ? std::span<const double>() : wanted,
                       .error = error,
                       .rounds = rounds,
                       .sharp_angle = sharp_angle,
                       .keep_boundary = keep_boundary,
                       .measured = true,
                       .go_on = go_on});
      });
  return std::make_tuple(places, counts.given, counts.left, counts.splits, counts.collapses, counts.flips,
                         *counts.distance, *counts.distance_back);
}

auto subdivide_copy(Mesh& mesh, const Doubles& points, bool by_loop, unsigned times, const py::object& progress) {
  return change_copy(
             mesh, points, long_work, progress,
             [&](auto& copy, auto& moved, const GoOn& go_on) {
               subdivide(
                   static_cast<meshops::Connectivity&>(copy), moved,
                   {.rule = by_loop ? SubdivisionRule::loop : SubdivisionRule::sqrt3, .times = times, .go_on = go_on});
               return true;
             })
      .first;
}

void bind_progressive(py::module_& module) {
  using py::arg;
  py::class_<ProgressiveMesh>(module, "ProgressiveMesh")
      .def(py::init([](Mesh& mesh, const Doubles& points, const py::object& progress) {
             const auto input = points3_of(points, "points");
             const Mesh::Look look(mesh);
             const std::size_t given = mesh.seen().n_faces();
             return watched(given, progress, [&](Watch& watch) {
               const OnProgress report = watch.progress();
               return ProgressiveMesh(mesh.seen(), {input.begin(), input.end()},
                                      {.go_on = go_on_of(report, input.size(), given)});
             });
           }),
           arg("mesh"), as_is("points"), arg("progress"))
      .def(py::init([](const py::bytes& bytes) {
             const auto text = static_cast<std::string_view>(bytes);
             return ProgressiveMesh::read(std::as_bytes(std::span(text)));
           }),
           arg("data"))
      .def(
          "to_bytes",
          [](const ProgressiveMesh& m) {
            const std::vector<std::byte> bytes = m.write();
            return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
          },
          "Returns the coarse mesh and the splits that lead to the full one, for `from_bytes`.")
      .def("go_to", &ProgressiveMesh::go_to, arg("faces"),
           "Changes the mesh to as many triangles as possible, at most `faces`, or to the coarse mesh.")
      .def_property_readonly("faces", &ProgressiveMesh::faces, "The number of triangles now.")
      .def_property_readonly("least", &ProgressiveMesh::least, "The number of triangles of the coarse mesh.")
      .def_property_readonly("most", &ProgressiveMesh::most, "The number of triangles of the given mesh.")
      .def(
          "triangles", [](const ProgressiveMesh& m) { return rows<std::int32_t>(m.triangles()); },
          "Returns the corners of each triangle now, as vertices of the given mesh: int32 array of shape (faces, 3).")
      .def(
          "points", [](const ProgressiveMesh& m) { return rows<double>(m.positions()); },
          "Returns the position now of each vertex of the given mesh; only those of `triangles` have a meaning.");
}

void bind_topology(py::class_<Mesh>& mesh) {
  using py::arg;
  mesh.def(
          "boundary_curves",
          [](const Mesh& m) {
            std::vector<Indices> curves;
            for (const meshops::BoundaryCurve& curve : meshops::boundary_curves(m.seen()))
              curves.push_back(line<std::int32_t>(numbers(std::vector<Halfedge>(curve.begin(), curve.end()))));
            return curves;
          },
          "Returns the boundary curves, each an int32 array of halfedges with the mesh on their right.")
      .def(
          "validate",
          [](const Mesh& m) {
            std::vector<std::string> said;
            for (const meshops::Defect& defect : meshops::validate(m.seen())) said.push_back(describe(defect));
            return said;
          },
          "Returns all defects that keep the mesh from being an oriented 2-manifold with boundary, as texts;\n"
          "[] if only operators have changed it.")
      .def("report", &report, arg("point_of_vertex") = py::none(),
           "Returns a Report. `point_of_vertex` is the point of each vertex; the vertices of a pinch share one.")
      .def("homology", &homology, arg("lengths") = py::none(),
           "Returns (generators, cut_graph): loops of halfedges that generate the first homology, a list of\n"
           "int32 arrays, and the edges that cut the mesh into discs, an int32 array. If `lengths` has the length of\n"
           "each edge, edge_bound numbers, the loops are short.")
      .def(
          "separate_fans", [](Mesh& m) { return line<std::int32_t>(numbers(meshops::separate_fans(m.changed()))); },
          "Gives each fan at a vertex a vertex of its own. Returns for each new vertex the vertex that it copies.")
      .def(
          "compact",
          [](Mesh& m) {
            m.changed();
            m.kernel().garbage_collection();
            m.built_on.clear();
          },
          "Removes deleted elements. All earlier handles and effects become invalid.")
      .def_property_readonly(
          "point_of_vertex", [](const Mesh& m) { return line<std::int32_t>(std::vector<std::uint32_t>(m.built_on)); },
          "The point, in the given faces, of each vertex that the mesh was built with. A point in which several\n"
          "fans met has a vertex for each.")
      .def("__repr__", [](const Mesh& m) {
        const meshops::TopologyCounts n = meshops::count_topology(m.seen());
        return "<rbpa.meshops.Mesh: " + std::to_string(n.vertices) + " vertices, " + std::to_string(n.edges) +
               " edges, " + std::to_string(n.faces) + " faces>";
      });
}

}  // namespace

void bind_mesh(py::module_& module) {
  using py::arg;
  py::class_<Mesh> mesh(module, "Mesh");
  mesh.def(py::init(&make_mesh), arg("corners"), arg("begin"), arg("points"));
  bind_elements(mesh);
  bind_navigation(mesh);
  bind_topology(mesh);
  bind_progressive(module);
  bind_mesh_operators(module, mesh);
  mesh.def("_decimate", &decimate_copy, as_is("points"), arg("faces"), arg("error"), arg("no_crossings"),
           arg("measured"), arg("progress"));
  mesh.def("_subdivide", &subdivide_copy, as_is("points"), arg("by_loop"), arg("times"), arg("progress"));
  mesh.def("_remesh", &remesh_copy, as_is("points"), as_is("length"), arg("error"), arg("rounds"), arg("sharp_angle"),
           arg("keep_boundary"), arg("progress"));
  mesh.def(py::pickle(&state_of, [](const py::tuple& state) {
    return mesh_of(state[0].cast<Indices>(), state[1].cast<Indices>(), state[2].cast<Indices>(),
                   state[3].cast<Indices>());
  }));
}

}  // namespace rbpa::python
