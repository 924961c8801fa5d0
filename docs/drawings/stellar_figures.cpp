#include <array>

#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/diagonal.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/triangulate_face.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"

namespace figures {
namespace {

using meshops::StarElements;

/// Returns marks on the elements that a split added.
Marks marked(const StarElements& added) {
  Marks marks;
  marks.add(added.vertex);
  for (const Edge e : added.edges()) marks.add(e);
  return marks;
}

void split_edge_row(Sheet& sheet, const DrawnMesh& before, Halfedge h) {
  DrawnMesh after = before;
  const auto effect = meshops::split_edge(after.mesh, h);
  after.move(effect.added.vertex, before.segment(h).middle());
  DrawnMesh back = after;
  meshops::weld_edge(back.mesh, effect.halfedge);
  require_same_counts(before, back);
  Marks edge;
  edge.add(before.mesh.edge_handle(h));
  Marks star = marked(effect.added);
  star.add(after.mesh.edge_handle(h));
  sheet.row(counted(before, edge), {"split_edge", "weld_edge"}, counted(after, star));
}

std::string split_edge() {
  Sheet sheet("Split puts a vertex on an edge, inner or on the boundary; weld takes it out");
  const DrawnMesh square = drawn_mesh({{0, 1}, {1.6, 0}, {3.2, 1}, {1.6, 2}}, {{0, 1, 3}, {1, 2, 3}});
  const DrawnMesh triangle = drawn_mesh({{0, 0}, {3.2, 0}, {1.6, 1.8}}, {{0, 1, 2}});
  split_edge_row(sheet, square, square.between(1, 3));
  split_edge_row(sheet, triangle, triangle.between(0, 1));
  return sheet.svg();
}

std::string split_face() {
  const DrawnMesh before = drawn_mesh({{0, 0}, {3, 0}, {1.5, 2.4}}, {{0, 1, 2}});
  DrawnMesh after = before;
  const auto effect = meshops::split_face(after.mesh, Face(0));
  after.move(effect.added.vertex, before.centroid(Face(0)));
  DrawnMesh back = after;
  meshops::weld_face(back.mesh, effect.added.vertex);
  require_same_counts(before, back);
  Marks face;
  face.add(Face(0));
  return Sheet("Split puts a vertex into a triangle, weld takes it out")
      .row(counted(before, face), {"split_face", "weld_face"}, counted(after, marked(effect.added)))
      .svg();
}

std::string flip() {
  const DrawnMesh before = drawn_mesh({{0, 1}, {1.7, 0}, {3.2, 1.1}, {1.5, 2.2}}, {{0, 1, 3}, {1, 2, 3}});
  DrawnMesh after = before;
  const Edge e = before.mesh.edge_handle(before.between(1, 3));
  meshops::flip(after.mesh, e);
  DrawnMesh back = after;
  meshops::flip(back.mesh, e);
  require_same_counts(before, back);
  Marks edge;
  edge.add(e);
  return Sheet("Flip rotates an edge inside its two triangles")
      .row(counted(before, edge), {"flip", "flip"}, counted(after, edge))
      .svg();
}

/// Returns two inner vertices, 0 and 1, with an edge between them, inside an octagon.
DrawnMesh two_wheels() {
  return drawn_mesh(
      {{1.4, 1.3},
       {2.8, 1.3},
       {4.2, 1.3},
       {3.6, 2.5},
       {2.1, 2.7},
       {0.6, 2.5},
       {0, 1.3},
       {0.6, 0.1},
       {2.1, -0.1},
       {3.6, 0.1}},
      {{0, 1, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 8}, {1, 0, 8}, {1, 8, 9}, {1, 9, 2}, {1, 2, 3}, {1, 3, 4}});
}

/// Returns marks on the merged edges and the vertex that took over.
Marks marked(const DrawnMesh& after, const meshops::WeldEffect& effect) {
  Marks marks;
  marks.add(effect.survivor);
  for (const auto& h : {effect.left, effect.right})
    if (h) marks.add(after.mesh.edge_handle(*h));
  return marks;
}

std::string collapse() {
  const DrawnMesh before = two_wheels();
  const Halfedge h = before.between(0, 1);
  DrawnMesh after = before;
  const auto effect = meshops::collapse(after.mesh, h);
  DrawnMesh back = after;
  meshops::split_vertex(back.mesh, effect.left, effect.right);
  require_same_counts(before, back);
  after.move(Vertex(1), {2.1, 1.3});
  Marks edge;
  edge.add(before.mesh.edge_handle(h));
  edge.add(Vertex(0));
  edge.add(Vertex(1));
  for (const Halfedge side : {h, before.mesh.opposite_halfedge_handle(h)}) edge.add(before.mesh.face_handle(side));
  return Sheet("Collapse makes one vertex of the two ends of an edge, split parts them")
      .row(counted(before, edge), {"collapse", "split_vertex"}, counted(after, marked(after, effect)))
      .svg();
}

std::string remove_vertex() {
  std::vector<Place> places = {{0, 0}};
  std::vector<Corners> faces;
  for (std::uint32_t i = 0; i < 6; ++i) {
    places.push_back(polar(60.0 * i, 1.6));
    faces.push_back({0, 1 + i, 1 + (i + 1) % 6});
  }
  const DrawnMesh before = drawn_mesh(places, faces);
  DrawnMesh after = before;
  const auto effect = meshops::remove_vertex(after.mesh, Vertex(0));
  DrawnMesh back = after;
  meshops::split_vertex(back.mesh, effect.left, effect.right);
  require_same_counts(before, back);
  Marks star, filled = marked(after, effect);
  star.add(Vertex(0));
  for (const Edge e : before.mesh.ve_range(Vertex(0))) star.add(e);
  for (const Edge e : after.mesh.ve_range(effect.survivor))
    if (!after.mesh.is_boundary(e)) filled.add(e);
  return Sheet("Remove takes a vertex out and fills its star with triangles again")
      .row(counted(before, star), {"remove_vertex", "split_vertex"}, counted(after, filled))
      .svg();
}

std::string triangulate_face() {
  const DrawnMesh before =
      drawn_mesh({{0.2, 0.3}, {1.3, 0}, {2.1, 0.7}, {3.2, 0.2}, {3.4, 1.5}, {2.4, 2.3}, {1.6, 1.5}, {0.6, 2.2}},
                 {{0, 1, 2, 3, 4, 5, 6, 7}});
  DrawnMesh after = before;
  const auto perimeter = [&](Vertex a, Vertex b, Vertex c) {
    const Place p = before.place(a), q = before.place(b), r = before.place(c);
    return length(p - q) + length(q - r) + length(r - p);
  };
  const auto effect = meshops::triangulate_face(after.mesh, Face(0), perimeter);
  DrawnMesh back = after;
  for (std::size_t i = effect.diagonals.size(); i-- > 0;) meshops::remove_diagonal(back.mesh, effect.diagonals[i]);
  require_same_counts(before, back);
  Marks face, diagonals;
  face.add(Face(0));
  for (const Halfedge h : effect.diagonals) diagonals.add(after.mesh.edge_handle(h));
  return Sheet("A polygon is cut into triangles along diagonals; taken out one after the other, they leave it again")
      .row(counted(before, face), {"triangulate_face", "remove_diagonal"}, counted(after, diagonals))
      .svg();
}

}  // namespace

std::span<const Figure> stellar_figures() {
  static constexpr std::array figures = {Figure{"stellar_split_edge", split_edge},
                                         Figure{"stellar_split_face", split_face},
                                         Figure{"stellar_flip", flip},
                                         Figure{"stellar_collapse", collapse},
                                         Figure{"stellar_remove_vertex", remove_vertex},
                                         Figure{"stellar_triangulate_face", triangulate_face}};
  return figures;
}

}  // namespace figures
