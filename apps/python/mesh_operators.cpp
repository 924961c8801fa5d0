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

namespace pybind11::detail {

template <>
struct type_caster<meshops::Keep> {
  PYBIND11_TYPE_CASTER(meshops::Keep, const_name("str"));

  bool load(handle source, bool convert) {
    make_caster<std::string> text;
    if (!text.load(source, convert)) return false;
    const auto& keep = cast_op<const std::string&>(text);
    value = keep == "manifold" ? meshops::Keep::manifold : meshops::Keep::simplicial;
    if (keep != "manifold" && keep != "simplicial")
      throw meshops::ContractViolation("keep: found '" + keep + "', expected 'simplicial' or 'manifold'");
    return true;
  }
};

}  // namespace pybind11::detail

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

Reason described(const std::optional<meshops::Blocker>& blocker) {
  return blocker ? Reason(describe(*blocker)) : std::nullopt;
}

void bind_delta(py::module_& module) {
  using meshops::Delta;
  py::class_<Delta>(module, "Delta", "The change of the counts of a mesh.")
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

/// Binds an effect: the record by which the change of an operator can be undone. In Python, handles are ints or None.
template <typename Effect, typename... Base>
py::class_<Effect, Base...> bind_effect(py::module_& module, const char* name, const char* what) {
  py::class_<Effect, Base...> effect(module, name, what);
  effect.attr("__module__") = "rbpa.meshops";
  effect.def_property_readonly(
      "delta", [](const Effect& e) { return e.delta(); }, "The change of the counts.");
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
  bind_effect<meshops::GlueEffect>(module, "GlueEffect", "The effect of glue(), undone by unglue().")
      .def_property_readonly("what", &case_of<meshops::GlueEffect>,
                             "'join', 'split curve', 'handle', 'zip' or 'close'.")
      .def_readonly("survivor", &meshops::GlueEffect::survivor, "The first halfedge, now inner.")
      .def_readonly("removed", &meshops::GlueEffect::removed, "The second halfedge, whose edge is deleted.");
  bind_effect<meshops::UnglueEffect>(module, "UnglueEffect", "The effect of unglue(), undone by glue(first, second).")
      .def_property_readonly("what", &case_of<meshops::UnglueEffect>, "The case of glue() that was undone.")
      .def_readonly("first", &meshops::UnglueEffect::first)
      .def_readonly("second", &meshops::UnglueEffect::second)
      .def_property_readonly(
          "new_start", [](const meshops::UnglueEffect& e) { return maybe(e.new_start); },
          "A second vertex where `first` starts, or None.")
      .def_property_readonly(
          "new_end", [](const meshops::UnglueEffect& e) { return maybe(e.new_end); },
          "A second vertex where `first` ends, or None.");
  bind_effect<meshops::CloseCurveEffect>(module, "CloseCurveEffect",
                                         "The effect of close_curve(), undone by open_curve(face).")
      .def_readonly("face", &meshops::CloseCurveEffect::face);
  bind_effect<meshops::OpenCurveEffect>(module, "OpenCurveEffect",
                                        "The effect of open_curve(), undone by close_curve(curve).")
      .def_readonly("curve", &meshops::OpenCurveEffect::curve);
  bind_effect<meshops::ZipCurvesEffect>(module, "ZipCurvesEffect", "The effect of zip_curves().")
      .def_property_readonly("begins_with",
                             [](const meshops::ZipCurvesEffect& e) { return std::string(name(e.begins_with())); })
      .def_property_readonly("edges", [](const meshops::ZipCurvesEffect& e) { return e.glued.size(); });
  bind_effect<meshops::CreateTriangleEffect>(module, "CreateTriangleEffect",
                                             "The effect of create_triangle(), undone by destroy_triangle(face).")
      .def_readonly("face", &meshops::CreateTriangleEffect::face)
      .def_readonly("inner", &meshops::CreateTriangleEffect::inner, "The first halfedge inside the triangle.")
      .def_readonly("boundary", &meshops::CreateTriangleEffect::boundary, "The opposite of `inner`.");
}

template <typename Effect>
py::class_<Effect> bind_split(py::module_& module, const char* name) {
  return bind_effect<Effect>(module, name, "The effect of a split, undone by collapse(halfedge).")
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
          "The halfedge from the new vertex to the one that it was split from.");
}

void bind_stellar_effects(py::module_& module) {
  bind_split<meshops::SplitEdgeEffect>(module, "SplitEdgeEffect").def_readonly("line", &meshops::SplitEdgeEffect::line);
  bind_split<meshops::SplitFaceEffect>(module, "SplitFaceEffect").def_readonly("face", &meshops::SplitFaceEffect::face);
  bind_split<meshops::SplitVertexEffect>(module, "SplitVertexEffect");
  using meshops::WeldEffect;
  const char* taken_back = "The effect of removing a vertex, undone by undo().";
  bind_effect<WeldEffect>(module, "WeldEffect", taken_back)
      .def_property_readonly(
          "vertex", [](const WeldEffect& e) { return e.removed.vertex; }, "The deleted vertex.")
      .def_readonly("survivor", &WeldEffect::survivor, "The vertex that took over its faces.")
      .def_readonly("left", &WeldEffect::left, "The edges between left and right were taken over.")
      .def_readonly("right", &WeldEffect::right);
  bind_effect<meshops::WeldEdgeEffect, WeldEffect>(module, "WeldEdgeEffect", taken_back)
      .def_readonly("line", &meshops::WeldEdgeEffect::line,
                    "The halfedge toward the survivor, of the edge that was two.");
  bind_effect<meshops::WeldFaceEffect, WeldEffect>(module, "WeldFaceEffect", taken_back)
      .def_readonly("face", &meshops::WeldFaceEffect::face, "The face that was three.");
  bind_effect<meshops::FlipEffect>(module, "FlipEffect", "The effect of flip(), undone by undo().")
      .def_readonly("edge", &meshops::FlipEffect::edge);
  bind_effect<meshops::InsertDiagonalEffect>(module, "InsertDiagonalEffect",
                                             "The effect of insert_diagonal(), undone by remove_diagonal(diagonal).")
      .def_readonly("diagonal", &meshops::InsertDiagonalEffect::diagonal)
      .def_readonly("face", &meshops::InsertDiagonalEffect::face);
  bind_effect<meshops::RemoveDiagonalEffect>(module, "RemoveDiagonalEffect",
                                             "The effect of remove_diagonal(), undone by insert_diagonal(start, end).")
      .def_readonly("edge", &meshops::RemoveDiagonalEffect::edge)
      .def_readonly("face", &meshops::RemoveDiagonalEffect::face)
      .def_readonly("survivor", &meshops::RemoveDiagonalEffect::survivor)
      .def_readonly("start", &meshops::RemoveDiagonalEffect::from)
      .def_readonly("end", &meshops::RemoveDiagonalEffect::to);
  bind_effect<meshops::TriangulateFaceEffect>(module, "TriangulateFaceEffect", "The effect of triangulate_face().")
      .def_readonly("diagonals", &meshops::TriangulateFaceEffect::diagonals)
      .def_readonly("faces", &meshops::TriangulateFaceEffect::faces);
}

/// Binds an operator with arguments `Given`, and the blocker of the operator. Both functions are stateless, and are
/// bound as function pointers, so that pybind11 compiles each signature only once.
template <typename... Given, typename Operator, typename Blocker, typename... Arguments>
void bind_operator(py::class_<Mesh>& mesh, const std::string& name, Operator, Blocker, const char* what,
                   const Arguments&... arguments) {
  mesh.def(
      name.c_str(), +[](Mesh& m, Given... given) { return Operator{}(m.changed(), given...); }, arguments..., what);
  mesh.def((name + "_blocker").c_str(),
           +[](const Mesh& m, Given... given) -> Reason { return described(Blocker{}(m.seen(), given...)); },
           arguments..., ("Returns why " + name + "() would refuse, or None.").c_str());
}

// Operators and blockers are overloaded, so lambdas select the overload.
#define RBPA_OPERATOR(name) \
#name, [](auto& on, const auto&... given) { return meshops::name(on, given...); }, \
      [](auto& on, const auto&... given) { return meshops::name##_blocker(on, given...); }

void bind_handle_operators(py::class_<Mesh>& mesh) {
  const arg halfedge("halfedge"), face("face"), first("first"), second("second");
  mesh.def(
      "create_triangle", [](Mesh& m) { return meshops::create_triangle(m.changed()); },
      "Adds a triangle of three new vertices.");
  bind_operator<Face>(mesh, RBPA_OPERATOR(destroy_triangle),
                      "Removes a triangle that is a component of its own. Returns the Delta.", face);
  bind_operator<Face>(
      mesh, RBPA_OPERATOR(remove_triangle),
      "Removes a triangle from any mesh; if the rest would touch itself in a corner, each fan gets a vertex.\n"
      "Returns the Delta.",
      face);
  bind_operator<Halfedge, Halfedge>(
      mesh, RBPA_OPERATOR(glue),
      "Glues two boundary halfedges head to tail: joins components, splits a curve, makes a handle, zips, closes.",
      first, second);
  bind_operator<Halfedge>(mesh, RBPA_OPERATOR(unglue),
                          "Separates the two faces at an inner edge: the inverse of glue().", halfedge);
  mesh.def(
      "unglue", [](Mesh& m, const meshops::GlueEffect& effect) { return meshops::unglue(m.changed(), effect); },
      arg("effect"), "Undoes a glue() exactly: restores every record.");
  bind_operator<Halfedge>(mesh, RBPA_OPERATOR(close_curve),
                          "Fills the boundary curve through a halfedge with one face.", halfedge);
  bind_operator<Face>(mesh, RBPA_OPERATOR(open_curve),
                      "Removes a face, and leaves a boundary curve: the inverse of close_curve().", face);
  bind_operator<Halfedge, Halfedge>(mesh, RBPA_OPERATOR(zip_curves),
                                    "Glues two boundary curves of equal length, edge by edge, from these halfedges on.",
                                    first, second);
}

void bind_stellar_operators(py::class_<Mesh>& mesh) {
  using Side = std::optional<Halfedge>;
  const arg halfedge("halfedge"), face("face"), vertex("vertex");
  const py::kw_only by_name;
  const py::arg_v keep = arg("keep") = "simplicial";
  bind_operator<Halfedge, Keep>(
      mesh, RBPA_OPERATOR(split_edge),
      "Inserts a vertex on the edge of a halfedge, and joins it to the apex of each triangle of the edge.", halfedge,
      by_name, keep);
  bind_operator<Face>(mesh, RBPA_OPERATOR(split_face), "Inserts a vertex into a triangle, and joins it to its corners.",
                      face);
  bind_operator<Side, Side, Keep>(
      mesh, RBPA_OPERATOR(split_vertex),
      "Splits the vertex that both halfedges leave: a new one takes over the edges between them, counter-clockwise.\n"
      "One of them may be None, for the boundary.",
      arg("left"), arg("right"), by_name, keep);
  bind_operator<Halfedge, Keep>(
      mesh, RBPA_OPERATOR(weld_edge),
      "Removes the vertex where a halfedge starts from its edge: the inverse of split_edge().", halfedge, by_name,
      keep);
  bind_operator<Vertex, Keep>(mesh, RBPA_OPERATOR(weld_face),
                              "Removes an inner vertex of degree three: the inverse of split_face().", vertex, by_name,
                              keep);
  bind_operator<Halfedge, Keep>(mesh, RBPA_OPERATOR(collapse),
                                "Merges the vertex where a halfedge starts into the one where it ends.", halfedge,
                                by_name, keep);
  bind_operator<Vertex, Keep>(mesh, RBPA_OPERATOR(remove_vertex),
                              "Collapses the first halfedge of a vertex that can be collapsed.", vertex, by_name, keep);
  bind_operator<Edge, Keep>(mesh, RBPA_OPERATOR(flip), "Turns an edge counter-clockwise inside its two triangles.",
                            arg("edge"), by_name, keep);
  mesh.def(
      "undo", [](Mesh& m, const meshops::FlipEffect& effect) { meshops::undo(m.changed(), effect); }, arg("effect"),
      "Undoes a flip.");
  mesh.def(
      "undo", [](Mesh& m, const meshops::WeldEffect& effect) { meshops::undo(m.changed(), effect); }, arg("effect"),
      "Undoes the removal of a vertex exactly: restores every record.");
  bind_operator<Halfedge, Halfedge, Keep>(mesh, RBPA_OPERATOR(insert_diagonal),
                                          "Cuts a face in two, between the corners where these sides of it start.",
                                          arg("start"), arg("end"), by_name, keep);
  bind_operator<Halfedge>(mesh, RBPA_OPERATOR(remove_diagonal), "Merges the two faces of an edge into one.", halfedge);
  mesh.def(
      "triangulate_face",
      [](Mesh& m, Face given, const py::function& weight, Keep kept) {
        const auto of = [&](Vertex a, Vertex b, Vertex c) { return double(py::float_(weight(a, b, c))); };
        meshops::Connectivity& mesh_to_change = m.changed();
        const Mesh::Look look(m);  // weight() must not change the mesh
        return meshops::triangulate_face(mesh_to_change, given, of, kept);
      },
      face, arg("weight"), by_name, keep,
      "Fills a face with the triangles of least total weight; weight(a, b, c) is a number for three of its "
      "corners.");
  mesh.def(
      "triangulate_face_blocker",
      [](const Mesh& m, Face given, Keep kept) -> Reason {
        return described(meshops::triangulate_face_blocker(m.seen(), given, kept));
      },
      face, by_name, keep, "Returns why triangulate_face() would refuse, or None.");
}

#undef RBPA_OPERATOR

}  // namespace

void bind_mesh_operators(py::module_& module, py::class_<Mesh>& mesh) {
  bind_delta(module);
  bind_handle_effects(module);
  bind_stellar_effects(module);
  bind_handle_operators(mesh);
  bind_stellar_operators(mesh);
}

}  // namespace rbpa::python
