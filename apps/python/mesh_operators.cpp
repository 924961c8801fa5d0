#include <optional>
#include <string>

#include "meshops/handle/close_curve.h"
#include "meshops/handle/create.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/glue.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/diagonal.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/triangulate_face.h"
#include "meshops/stellar/undo.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "python/mesh.h"

namespace rbpa::python {
namespace {

namespace py = pybind11;
using meshops::Edge;
using meshops::Face;
using meshops::Halfedge;
using meshops::Keep;
using meshops::Vertex;
using py::arg;
using Reason = std::optional<std::string>;

Keep keep_of(const std::string& keep) {
  if (keep == "simplicial") return Keep::simplicial;
  if (keep == "manifold") return Keep::manifold;
  throw meshops::ContractViolation("keep: found '" + keep + "', expected 'simplicial' or 'manifold'");
}

void bind_delta(py::module_& module) {
  using meshops::Delta;
  py::class_<Delta>(module, "Delta", "By how much the counts of a mesh changed.")
      .def_readonly("vertices", &Delta::vertices)
      .def_readonly("edges", &Delta::edges)
      .def_readonly("faces", &Delta::faces)
      .def_readonly("curves", &Delta::curves)
      .def_readonly("components", &Delta::components)
      .def_readonly("genus", &Delta::genus)
      .def_property_readonly("euler", &Delta::euler)
      .def("__neg__", [](const Delta& d) { return -d; })
      .def("__add__", [](const Delta& a, const Delta& b) { return a + b; })
      .def("__eq__", [](const Delta& a, const Delta& b) { return a == b; })
      .def("__repr__",
           [](const Delta& d) {
             return "Delta(vertices=" + std::to_string(d.vertices) + ", edges=" + std::to_string(d.edges) +
                    ", faces=" + std::to_string(d.faces) + ", curves=" + std::to_string(d.curves) +
                    ", components=" + std::to_string(d.components) + ", genus=" + std::to_string(d.genus) + ")";
           })
      .attr("__module__") = "rbpa.meshops";
}

/// An effect is what an operator did, and what takes it back. Handles are ints, or None.
template <typename Effect, typename... Base>
py::class_<Effect, Base...> bind_effect(py::module_& module, const char* name, const char* what) {
  py::class_<Effect, Base...> effect(module, name, what);
  effect.attr("__module__") = "rbpa.meshops";
  effect.def_property_readonly(
      "delta", [](const Effect& e) { return e.delta(); }, "By how much the counts changed.");
  effect.def("__repr__", [name](const Effect& e) {
    return "<rbpa.meshops." + std::string(name) + ": " + py::repr(py::cast(e.delta())).template cast<std::string>() +
           ">";
  });
  return effect;
}

template <typename Effect>
std::string case_of(const Effect& effect) {
  return std::string(name(effect.what));
}

void bind_handle_effects(py::module_& module) {
  bind_effect<meshops::GlueEffect>(module, "GlueEffect", "What glue() did; unglue() takes it back.")
      .def_property_readonly("what", &case_of<meshops::GlueEffect>,
                             "'join', 'split curve', 'handle', 'zip' or 'close'.")
      .def_readonly("survivor", &meshops::GlueEffect::survivor, "The first halfedge, now inner.")
      .def_readonly("removed", &meshops::GlueEffect::removed, "The second halfedge, whose edge is deleted.");
  bind_effect<meshops::UnglueEffect>(module, "UnglueEffect", "What unglue() did; glue(first, second) takes it back.")
      .def_property_readonly("what", &case_of<meshops::UnglueEffect>, "The case of glue() that was undone.")
      .def_readonly("first", &meshops::UnglueEffect::first)
      .def_readonly("second", &meshops::UnglueEffect::second)
      .def_readonly("new_start", &meshops::UnglueEffect::new_start, "A second vertex where `first` starts, or None.")
      .def_readonly("new_end", &meshops::UnglueEffect::new_end, "A second vertex where `first` ends, or None.");
  bind_effect<meshops::CloseCurveEffect>(module, "CloseCurveEffect",
                                         "What close_curve() did; open_curve(face) undoes it.")
      .def_readonly("face", &meshops::CloseCurveEffect::face);
  bind_effect<meshops::OpenCurveEffect>(module, "OpenCurveEffect",
                                        "What open_curve() did; close_curve(curve) undoes it.")
      .def_readonly("curve", &meshops::OpenCurveEffect::curve);
  bind_effect<meshops::ZipCurvesEffect>(module, "ZipCurvesEffect", "What zip_curves() did.")
      .def_property_readonly("begins_with",
                             [](const meshops::ZipCurvesEffect& e) { return std::string(name(e.begins_with)); })
      .def_readonly("edges", &meshops::ZipCurvesEffect::edges);
}

template <typename Effect>
py::class_<Effect> bind_split(py::module_& module, const char* name) {
  return bind_effect<Effect>(module, name, "What a split did; collapse(halfedge) takes it back.")
      .def_property_readonly(
          "vertex", [](const Effect& e) { return e.added.vertex; }, "The new vertex.")
      .def_property_readonly(
          "edges", [](const Effect& e) { return std::vector<Edge>(e.added.edges().begin(), e.added.edges().end()); },
          "The new edges.")
      .def_property_readonly(
          "faces", [](const Effect& e) { return std::vector<Face>(e.added.faces().begin(), e.added.faces().end()); },
          "The new faces.")
      .def_property_readonly(
          "halfedge", [](const Effect& e) { return e.halfedge; },
          "From the new vertex to the one that it was split from.");
}

void bind_stellar_effects(py::module_& module) {
  bind_split<meshops::SplitEdgeEffect>(module, "SplitEdgeEffect").def_readonly("line", &meshops::SplitEdgeEffect::line);
  bind_split<meshops::SplitFaceEffect>(module, "SplitFaceEffect").def_readonly("face", &meshops::SplitFaceEffect::face);
  bind_split<meshops::SplitVertexEffect>(module, "SplitVertexEffect");
  using meshops::WeldEffect;
  const char* taken_back = "What took a vertex out did; undo() takes it back.";
  bind_effect<WeldEffect>(module, "WeldEffect", taken_back)
      .def_property_readonly(
          "vertex", [](const WeldEffect& e) { return e.removed.vertex; }, "The vertex that is deleted.")
      .def_readonly("survivor", &WeldEffect::survivor, "The vertex that took over its faces.")
      .def_readonly("left", &WeldEffect::left, "Between left and right lies what was taken over.")
      .def_readonly("right", &WeldEffect::right);
  bind_effect<meshops::WeldEdgeEffect, WeldEffect>(module, "WeldEdgeEffect", taken_back)
      .def_readonly("line", &meshops::WeldEdgeEffect::line, "Of the edge that was two, towards the survivor.");
  bind_effect<meshops::WeldFaceEffect, WeldEffect>(module, "WeldFaceEffect", taken_back)
      .def_readonly("face", &meshops::WeldFaceEffect::face, "The face that was three.");
  bind_effect<meshops::FlipEffect>(module, "FlipEffect", "What flip() did; undo() takes it back.")
      .def_readonly("edge", &meshops::FlipEffect::edge);
  bind_effect<meshops::InsertDiagonalEffect>(module, "InsertDiagonalEffect",
                                             "What insert_diagonal() did; remove_diagonal(diagonal) takes it back.")
      .def_readonly("diagonal", &meshops::InsertDiagonalEffect::diagonal)
      .def_readonly("face", &meshops::InsertDiagonalEffect::face);
  bind_effect<meshops::RemoveDiagonalEffect>(module, "RemoveDiagonalEffect",
                                             "What remove_diagonal() did; insert_diagonal(start, end) takes it back.")
      .def_readonly("edge", &meshops::RemoveDiagonalEffect::edge)
      .def_readonly("face", &meshops::RemoveDiagonalEffect::face)
      .def_readonly("survivor", &meshops::RemoveDiagonalEffect::survivor)
      .def_readonly("start", &meshops::RemoveDiagonalEffect::from)
      .def_readonly("end", &meshops::RemoveDiagonalEffect::to);
  bind_effect<meshops::TriangulateFaceEffect>(module, "TriangulateFaceEffect", "What triangulate_face() did.")
      .def_readonly("diagonals", &meshops::TriangulateFaceEffect::diagonals)
      .def_readonly("faces", &meshops::TriangulateFaceEffect::faces);
}

/// An operator on one element, and its blocker.
template <typename Element, typename Operator, typename Blocker>
void bind_pair(py::class_<Mesh>& mesh, const std::string& name, const char* element, Operator apply, Blocker blocker,
               const char* what) {
  mesh.def(
      name.c_str(), [apply](Mesh& m, Element e) { return apply(m.changed(), e); }, arg(element), what);
  mesh.def((name + "_blocker").c_str(), [blocker](const Mesh& m, Element e) -> Reason { return blocker(m.seen(), e); },
           arg(element), ("Why " + name + "() would refuse, or None.").c_str());
}

/// The same with what must be kept.
template <typename Element, typename Operator, typename Blocker>
void bind_keeping(py::class_<Mesh>& mesh, const std::string& name, const char* element, Operator apply, Blocker blocker,
                  const char* what) {
  mesh.def(
      name.c_str(),
      [apply](Mesh& m, Element e, const std::string& keep) { return apply(m.changed(), e, keep_of(keep)); },
      arg(element), py::kw_only(), arg("keep") = "simplicial", what);
  mesh.def((name + "_blocker").c_str(),
           [blocker](const Mesh& m, Element e, const std::string& keep) -> Reason {
             return blocker(m.seen(), e, keep_of(keep));
           },
           arg(element), py::kw_only(), arg("keep") = "simplicial",
           ("Why " + name + "() would refuse, or None.").c_str());
}

/// An operator on two halfedges, and its blocker.
template <typename Operator, typename Blocker>
void bind_two(py::class_<Mesh>& mesh, const std::string& name, Operator apply, Blocker blocker, const char* what) {
  mesh.def(
      name.c_str(), [apply](Mesh& m, Halfedge a, Halfedge b) { return apply(m.changed(), a, b); }, arg("first"),
      arg("second"), what);
  mesh.def((name + "_blocker").c_str(),
           [blocker](const Mesh& m, Halfedge a, Halfedge b) -> Reason { return blocker(m.seen(), a, b); }, arg("first"),
           arg("second"), ("Why " + name + "() would refuse, or None.").c_str());
}

// Operators and blockers have overloads: each is named by a function of its own.
#define RBPA_CALL(function) [](auto& on, const auto&... given) { return meshops::function(on, given...); }

void bind_handle_operators(py::class_<Mesh>& mesh) {
  mesh.def(
      "create_triangle", [](Mesh& m) { return meshops::create_triangle(m.changed()); },
      "Adds a triangle of three new vertices. Returns its first inner halfedge.");
  bind_pair<Face>(mesh, "destroy_triangle", "face", RBPA_CALL(destroy_triangle), RBPA_CALL(destroy_triangle_blocker),
                  "Takes out a triangle that is a component of its own. Returns the Delta.");
  bind_pair<Face>(
      mesh, "remove_triangle", "face", RBPA_CALL(remove_triangle), RBPA_CALL(remove_triangle_blocker),
      "Takes a triangle out of any mesh; where the rest would touch itself in a corner, each fan gets a vertex.\n"
      "Returns the Delta.");
  bind_two(
      mesh, "glue", RBPA_CALL(glue), RBPA_CALL(glue_blocker),
      "Glues two boundary halfedges head to tail: joins components, splits a curve, makes a handle, zips, closes.");
  bind_pair<Halfedge>(mesh, "unglue", "halfedge", RBPA_CALL(unglue), RBPA_CALL(unglue_blocker),
                      "Parts an inner edge: the inverse of glue().");
  mesh.def(
      "unglue", [](Mesh& m, const meshops::GlueEffect& effect) { return meshops::unglue(m.changed(), effect); },
      arg("effect"), "Takes a glue() back: every record is as it was.");
  bind_pair<Halfedge>(mesh, "close_curve", "halfedge", RBPA_CALL(close_curve), RBPA_CALL(close_curve_blocker),
                      "Fills the boundary curve through a halfedge with one face.");
  bind_pair<Face>(mesh, "open_curve", "face", RBPA_CALL(open_curve), RBPA_CALL(open_curve_blocker),
                  "Takes a face out, and leaves a boundary curve: the inverse of close_curve().");
  bind_two(mesh, "zip_curves", RBPA_CALL(zip_curves), RBPA_CALL(zip_curves_blocker),
           "Sews two boundary curves of equal length together, edge by edge, from these halfedges on.");
}

void bind_splits(py::class_<Mesh>& mesh) {
  bind_keeping<Halfedge>(mesh, "split_edge", "halfedge", RBPA_CALL(split_edge), RBPA_CALL(split_edge_blocker),
                         "Puts a vertex on the edge of a halfedge, joined to the apex of each triangle beside it.");
  bind_pair<Face>(mesh, "split_face", "face", RBPA_CALL(split_face), RBPA_CALL(split_face_blocker),
                  "Puts a vertex into a triangle, joined to its corners.");
  using Side = std::optional<Halfedge>;
  mesh.def(
      "split_vertex",
      [](Mesh& m, Side left, Side right, const std::string& keep) {
        return meshops::split_vertex(m.changed(), left, right, keep_of(keep));
      },
      arg("left"), arg("right"), py::kw_only(), arg("keep") = "simplicial",
      "Splits the vertex that both halfedges leave: a new one takes over the edges between them, counter-clockwise. "
      "One may\n"
      "be None: from or to the boundary.");
  mesh.def(
      "split_vertex_blocker",
      [](const Mesh& m, Side left, Side right, const std::string& keep) -> Reason {
        return meshops::split_vertex_blocker(m.seen(), left, right, keep_of(keep));
      },
      arg("left"), arg("right"), py::kw_only(), arg("keep") = "simplicial",
      "Why split_vertex() would refuse, or None.");
}

void bind_welds(py::class_<Mesh>& mesh) {
  bind_keeping<Halfedge>(mesh, "weld_edge", "halfedge", RBPA_CALL(weld_edge), RBPA_CALL(weld_edge_blocker),
                         "Takes the vertex where a halfedge starts out of its edge: the inverse of split_edge().");
  bind_keeping<Vertex>(mesh, "weld_face", "vertex", RBPA_CALL(weld_face), RBPA_CALL(weld_face_blocker),
                       "Takes an inner vertex of degree three out: the inverse of split_face().");
  bind_keeping<Halfedge>(mesh, "collapse", "halfedge", RBPA_CALL(collapse), RBPA_CALL(collapse_blocker),
                         "The vertex where a halfedge starts vanishes into the one where it ends.");
  bind_keeping<Vertex>(mesh, "remove_vertex", "vertex", RBPA_CALL(remove_vertex), RBPA_CALL(remove_vertex_blocker),
                       "Collapses the first halfedge of a vertex that can be.");
  bind_keeping<Edge>(mesh, "flip", "edge", RBPA_CALL(flip), RBPA_CALL(flip_blocker),
                     "Turns an edge counter-clockwise inside its two triangles.");
  mesh.def(
      "undo", [](Mesh& m, const meshops::FlipEffect& effect) { meshops::undo(m.changed(), effect); }, arg("effect"),
      "Takes a flip back.");
  mesh.def(
      "undo", [](Mesh& m, const meshops::WeldEffect& effect) { meshops::undo(m.changed(), effect); }, arg("effect"),
      "Takes back what took a vertex out: every record is as it was.");
}

void bind_diagonals(py::class_<Mesh>& mesh) {
  mesh.def(
      "insert_diagonal",
      [](Mesh& m, Halfedge start, Halfedge end, const std::string& keep) {
        return meshops::insert_diagonal(m.changed(), start, end, keep_of(keep));
      },
      arg("start"), arg("end"), py::kw_only(), arg("keep") = "simplicial",
      "Cuts a face in two, between the corners where these sides of it start.");
  mesh.def(
      "insert_diagonal_blocker",
      [](const Mesh& m, Halfedge start, Halfedge end, const std::string& keep) -> Reason {
        return meshops::insert_diagonal_blocker(m.seen(), start, end, keep_of(keep));
      },
      arg("start"), arg("end"), py::kw_only(), arg("keep") = "simplicial",
      "Why insert_diagonal() would refuse, or None.");
  bind_pair<Halfedge>(mesh, "remove_diagonal", "halfedge", RBPA_CALL(remove_diagonal),
                      RBPA_CALL(remove_diagonal_blocker), "Makes one face of the two beside an edge.");
  mesh.def(
      "triangulate_face",
      [](Mesh& m, Face face, const py::function& weight, const std::string& keep) {
        const auto of = [&](Vertex a, Vertex b, Vertex c) { return double(py::float_(weight(a, b, c))); };
        meshops::Connectivity& mesh_to_change = m.changed();
        const Mesh::Look look(m);  // so that weight() cannot change it
        return meshops::triangulate_face(mesh_to_change, face, of, keep_of(keep));
      },
      arg("face"), arg("weight"), py::kw_only(), arg("keep") = "simplicial",
      "Fills a face with the triangles of least total weight, weight(a, b, c) being a number for three of its "
      "corners.");
  mesh.def(
      "triangulate_face_blocker",
      [](const Mesh& m, Face face, const std::string& keep) -> Reason {
        return meshops::triangulate_face_blocker(m.seen(), face, keep_of(keep));
      },
      arg("face"), py::kw_only(), arg("keep") = "simplicial", "Why triangulate_face() would refuse, or None.");
}

#undef RBPA_CALL

}  // namespace

void bind_mesh_operators(py::module_& module, py::class_<Mesh>& mesh) {
  bind_delta(module);
  bind_handle_effects(module);
  bind_stellar_effects(module);
  bind_handle_operators(mesh);
  bind_splits(mesh);
  bind_welds(mesh);
  bind_diagonals(mesh);
}

}  // namespace rbpa::python
