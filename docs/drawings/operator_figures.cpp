// What: operators that change a mesh, before and after. Each is undone, and the counts must be those of before.
#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "meshops/core/live.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/insert_triangle.h"
#include "meshops/handle/unglue.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/weld_edge.h"

namespace figures {
namespace {

template <typename... Elements>
Marks marked(Elements... elements) {
  Marks marks;
  (marks.add(elements), ...);
  return marks;
}

void mark_with_ends(Marks& marks, const DrawnMesh& drawn, Halfedge h) {
  marks.add(drawn.mesh.edge_handle(h));
  marks.add(drawn.mesh.from_vertex_handle(h));
  marks.add(drawn.mesh.to_vertex_handle(h));
}

std::string drawn(const char* title, const Panel& before, const Arrow& arrow, const Panel& after) {
  return Sheet(title).row(before, arrow, after).svg();
}

/// Draws a figure of glue(): `arrange` gives the merged vertices their places, and may label them.
template <typename Arrange>
std::string glued(const char* title, const DrawnMesh& before, Halfedge first, Halfedge second, Arrange arrange) {
  DrawnMesh after = before;
  const meshops::GlueEffect effect = meshops::glue(after.mesh, first, second);
  DrawnMesh back = after;
  meshops::unglue(back.mesh, effect);
  require_same_counts(before, back);
  Marks edges, edge;
  mark_with_ends(edges, before, first);
  mark_with_ends(edges, before, second);
  mark_with_ends(edge, after, first);
  arrange(after, edge);
  return drawn(title, counted(before, edges), {"glue", "unglue", std::string(name(effect.what))}, counted(after, edge));
}

/// Inserts a triangle along its three former boundary edges.
DrawnMesh filled_again(DrawnMesh drawn) {
  const Halfedge top = drawn.boundary_between(4, 3);
  meshops::TriangleSides sides;
  sides.side = {drawn.mesh.prev_halfedge_handle(top), top, drawn.mesh.next_halfedge_handle(top)};
  const auto inserted = meshops::insert_triangle(drawn.mesh, sides);
  for (int i = 0; i < inserted.merged; ++i)
    drawn.mesh.status(inserted.left_over[static_cast<unsigned>(i)]).set_deleted(true);
  return drawn;
}

void split_edge_row(Sheet& sheet, const DrawnMesh& before, Halfedge h) {
  DrawnMesh after = before;
  const auto effect = meshops::split_edge(after.mesh, h);
  after.move(effect.added.vertex, before.segment(h).middle());
  DrawnMesh back = after;
  meshops::weld_edge(back.mesh, effect.halfedge);
  require_same_counts(before, back);
  Marks star = marked(effect.added.vertex, after.mesh.edge_handle(h));
  for (const Edge e : effect.added.edges()) star.add(e);
  sheet.row(counted(before, marked(before.mesh.edge_handle(h))), {"split_edge", "weld_edge"}, counted(after, star));
}

}  // namespace

std::string glue_join() {
  const DrawnMesh before = drawn_mesh(
      {{0, 0.2}, {1.3, 0}, {1.3, 1.7}, {0.1, 1.5}, {2.3, 0.1}, {3.5, 0.4}, {3.5, 1.3}, {2.3, 1.8}, {4.3, 0.8}},
      {{0, 1, 3}, {1, 2, 3}, {4, 5, 7}, {5, 6, 7}, {5, 8, 6}});
  return glued("Glue joins two components", before, before.boundary_between(1, 2), before.boundary_between(4, 7),
               [](DrawnMesh& after, Marks&) {
                 after.move(Vertex(1), {1.8, 0.05});
                 after.move(Vertex(2), {1.8, 1.75});
               });
}

std::string glue_split_curve() {
  const Ring open = ring(7, 18, 342, 0.8, 1.7);
  const DrawnMesh before = drawn_mesh(open.places, open.faces);
  return glued("Glue splits a curve: two edges of it that are not adjacent", before, before.boundary_between(7, 15),
               before.boundary_between(0, 8), [](DrawnMesh& after, Marks&) {
                 after.move(Vertex(0), Vertex(7), {1.7, 0});
                 after.move(Vertex(8), Vertex(15), {0.8, 0});
               });
}

std::string glue_handle() {
  const Ring closed = ring(6, 30, 390, 0.75, 1.8);
  const DrawnMesh before = drawn_mesh(closed.places, closed.faces);
  const Halfedge outer = before.boundary_between(0, 1), inner = before.boundary_between(9, 10);
  return glued("Glue makes a handle: edges on two curves of one component", before, outer, inner,
               [&](DrawnMesh& after, Marks& edge) {
                 // The faces stay at their places: the edge is drawn twice, and so are its ends.
                 meshops::for_each_face(before.mesh, [&](Face f) {
                   for (const Halfedge h : before.mesh.fh_range(f))
                     after.apart[h == before.mesh.opposite_halfedge_handle(inner) ? outer : h] = before.segment(h).to;
                 });
                 const auto label = [&](Vertex v, double radius, const char* words) {
                   edge.labels.push_back({radius * direction(before.place(v)), words});
                 };
                 label(before.mesh.from_vertex_handle(outer), 2.05, "a");
                 label(before.mesh.to_vertex_handle(inner), 0.5, "a");
                 label(before.mesh.to_vertex_handle(outer), 2.05, "b");
                 label(before.mesh.from_vertex_handle(inner), 0.5, "b");
               });
}

std::string glue_zip() {
  std::vector<Place> places = {{0, 0}};
  std::vector<Corners> faces;
  for (int i = 0; i <= 6; ++i) places.push_back(polar(20 + 320 * i / 6.0, 1.6));
  for (std::uint32_t i = 1; i <= 6; ++i) faces.push_back({0, i, i + 1});
  const DrawnMesh before = drawn_mesh(places, faces);
  return glued("Glue zips adjacent edges of a curve: the vertex between them turns inner", before,
               before.boundary_between(0, 1), before.boundary_between(0, 7), [](DrawnMesh& after, Marks&) {
                 after.move(Vertex(1), Vertex(7), {1.6, 0});
               });
}

std::string glue_close() {
  DrawnMesh before =
      drawn_mesh({{-0.8, 0}, {0.8, 0}, {2, 0}, {1, 1.5}, {-1, 1.5}, {-2, 0}, {-1, -1.5}, {1, -1.5}},
                 {{0, 1, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {1, 0, 6}, {1, 6, 7}, {1, 7, 2}, {1, 2, 3}});
  const auto slit = meshops::unglue(before.mesh, before.between(0, 1));
  for (const Halfedge h : {slit.first, slit.second}) {
    const bool above = before.mesh.face_handle(before.mesh.opposite_halfedge_handle(h)) == Face(0);
    before.bend[before.mesh.edge_handle(h)] = {0, above ? 0.6 : -0.6};
  }
  return glued("Glue closes a curve of two edges", before, slit.first, slit.second,
               [](DrawnMesh& after, Marks&) { after.bend.clear(); });
}

std::string remove_triangle() {
  const DrawnMesh before = drawn_mesh(
      {{-2, 0}, {0, 0}, {2, 0}, {-1, 1.3}, {1, 1.3}, {-3, 1.3}, {3, 1.3}, {-2, 2.6}, {0, 2.6}, {2, 2.6}},
      {{1, 4, 3}, {0, 1, 3}, {1, 2, 4}, {0, 3, 5}, {2, 6, 4}, {5, 3, 7}, {3, 8, 7}, {3, 4, 8}, {4, 9, 8}, {4, 6, 9}});
  DrawnMesh after = before;
  meshops::remove_triangle(after.mesh, Face(0));
  require_same_counts(before, filled_again(after));
  Marks corners;
  // Fans that met at one vertex lie slightly apart, each on its side.
  meshops::for_each_vertex(after.mesh, [&](Vertex v) {
    if (!(after.place(v) == before.place(Vertex(1)))) return;
    corners.add(v);
    after.move(v, {after.mesh.find_halfedge(v, Vertex(3)).is_valid() ? -0.16 : 0.16, 0});
  });
  return drawn("Remove takes a triangle out; where the rest would touch itself a vertex becomes two",
               counted(before, marked(Face(0), Vertex(1))), {"remove_triangle", "insert_triangle"},
               counted(after, corners));
}

std::string split_edge() {
  Sheet sheet("Split puts a vertex on an edge, inner or on the boundary; weld takes it out");
  const DrawnMesh square = drawn_mesh({{0, 1}, {1.6, 0}, {3.2, 1}, {1.6, 2}}, {{0, 1, 3}, {1, 2, 3}});
  const DrawnMesh triangle = drawn_mesh({{0, 0}, {3.2, 0}, {1.6, 1.8}}, {{0, 1, 2}});
  split_edge_row(sheet, square, square.between(1, 3));
  split_edge_row(sheet, triangle, triangle.between(0, 1));
  return sheet.svg();
}

std::string collapse() {
  // Two inner vertices, 0 and 1, with an edge between them, inside an octagon.
  const DrawnMesh before = drawn_mesh(
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
  const Halfedge h = before.between(0, 1);
  DrawnMesh after = before;
  const auto effect = meshops::collapse(after.mesh, h);
  DrawnMesh back = after;
  meshops::split_vertex(back.mesh, effect.left, effect.right);
  require_same_counts(before, back);
  after.move(effect.survivor, {2.1, 1.3});
  Marks edge = marked(before.mesh.face_handle(h), before.mesh.opposite_face_handle(h)),
        merged = marked(effect.survivor);
  mark_with_ends(edge, before, h);
  for (const auto& side : {effect.left, effect.right})
    if (side) merged.add(after.mesh.edge_handle(*side));
  return drawn("Collapse makes one vertex of the two ends of an edge, split separates them", counted(before, edge),
               {"collapse", "split_vertex"}, counted(after, merged));
}

}  // namespace figures
