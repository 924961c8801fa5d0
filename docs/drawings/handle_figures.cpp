#include <array>

#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "meshops/core/live.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/create.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/insert_triangle.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"

namespace figures {
namespace {

using meshops::GlueEffect;

std::string sheet_of(const char* title, const Panel& before, const Arrow& arrow, const Panel& after) {
  return Sheet(title).row(before, arrow, after).svg();
}

/// Returns marks on edges and their ends.
Marks marked_edges(const DrawnMesh& drawn, std::initializer_list<Halfedge> halfedges) {
  Marks marks;
  for (const Halfedge h : halfedges) {
    marks.add(drawn.mesh.edge_handle(h));
    marks.add(drawn.mesh.from_vertex_handle(h));
    marks.add(drawn.mesh.to_vertex_handle(h));
  }
  return marks;
}

/// Draws a figure of glue(): `arrange` gives the merged vertices their places, and may label them.
template <typename Arrange>
std::string glue_figure(const char* title, const DrawnMesh& before, Halfedge first, Halfedge second, Arrange arrange) {
  DrawnMesh after = before;
  const GlueEffect effect = meshops::glue(after.mesh, first, second);
  DrawnMesh back = after;
  meshops::unglue(back.mesh, effect);
  require_same_counts(before, back);
  Marks glued = marked_edges(after, {first});
  arrange(after, glued);
  return sheet_of(title, counted(before, marked_edges(before, {first, second})),
                  {"glue", "unglue", std::string(name(effect.what))}, counted(after, glued));
}

std::string create() {
  DrawnMesh nothing, after;
  const Halfedge h = meshops::create_triangle(after.mesh);
  after.move(Vertex(0), {0, 0});
  after.move(Vertex(1), {2, 0});
  after.move(Vertex(2), {1, 1.7});
  DrawnMesh back = after;
  meshops::destroy_triangle(back.mesh, after.mesh.face_handle(h));
  require_same_counts(nothing, back);
  Panel empty = counted(nothing);
  empty.more = [](Canvas& canvas, const Frame& frame) {
    canvas.text(frame({1, 0.8}), "the empty mesh", Lettering::small, Align::middle);
  };
  Marks all;
  all.add(Face(0));
  for (int i = 0; i < 3; ++i) all.add(Vertex(i));
  return sheet_of("Create makes a triangle out of nothing, destroy takes it away", empty,
                  {"create_triangle", "destroy_triangle"}, counted(after, all));
}

std::string glue_join() {
  const DrawnMesh before = drawn_mesh(
      {{0, 0.2}, {1.3, 0}, {1.3, 1.7}, {0.1, 1.5}, {2.3, 0.1}, {3.5, 0.4}, {3.5, 1.3}, {2.3, 1.8}, {4.3, 0.8}},
      {{0, 1, 3}, {1, 2, 3}, {4, 5, 7}, {5, 6, 7}, {5, 8, 6}});
  return glue_figure("Glue joins two components", before, before.boundary_between(1, 2), before.boundary_between(4, 7),
                     [](DrawnMesh& after, Marks&) {
                       after.move(Vertex(1), {1.8, 0.05});
                       after.move(Vertex(2), {1.8, 1.75});
                     });
}

std::string glue_split_curve() {
  const Ring open = ring(7, 18, 342, 0.8, 1.7);
  const DrawnMesh before = drawn_mesh(open.places, open.faces);
  return glue_figure("Glue splits a curve: two edges of it that are not adjacent", before,
                     before.boundary_between(7, 15), before.boundary_between(0, 8), [](DrawnMesh& after, Marks&) {
                       after.move(Vertex(0), Vertex(7), {1.7, 0});
                       after.move(Vertex(8), Vertex(15), {0.8, 0});
                     });
}

std::string glue_handle() {
  const Ring closed = ring(6, 30, 390, 0.75, 1.8);
  DrawnMesh before = drawn_mesh(closed.places, closed.faces);
  const Halfedge outer = before.boundary_between(0, 1), inner = before.boundary_between(9, 10);
  return glue_figure("Glue makes a handle: edges on two curves of one component", before, outer, inner,
                     [&](DrawnMesh& after, Marks& glued) {
                       // The faces stay at their places: the edge is drawn twice, and so are its ends.
                       meshops::for_each_face(before.mesh, [&](Face f) {
                         for (const Halfedge h : before.mesh.fh_range(f)) {
                           const Halfedge now = h == before.mesh.opposite_halfedge_handle(inner) ? outer : h;
                           after.apart[now] = before.segment(h).to;
                         }
                       });
                       const auto label = [&](Vertex v, double radius, const char* words) {
                         glued.labels.push_back({radius * direction(before.place(v)), words});
                       };
                       label(before.mesh.from_vertex_handle(outer), 2.05, "a");
                       label(before.mesh.to_vertex_handle(inner), 0.5, "a");
                       label(before.mesh.to_vertex_handle(outer), 2.05, "b");
                       label(before.mesh.from_vertex_handle(inner), 0.5, "b");
                     });
}

std::string glue_zip() {
  std::vector<Place> places = {{0, 0}};
  for (int i = 0; i <= 6; ++i) places.push_back(polar(20 + 320 * i / 6.0, 1.6));
  std::vector<Corners> faces;
  for (std::uint32_t i = 1; i <= 6; ++i) faces.push_back({0, i, i + 1});
  const DrawnMesh before = drawn_mesh(places, faces);
  return glue_figure("Glue zips adjacent edges of a curve: the vertex between them turns inner", before,
                     before.boundary_between(0, 1), before.boundary_between(0, 7), [](DrawnMesh& after, Marks&) {
                       after.move(Vertex(1), Vertex(7), {1.6, 0});
                     });
}

std::string glue_close() {
  const DrawnMesh closed =
      drawn_mesh({{-0.8, 0}, {0.8, 0}, {2, 0}, {1, 1.5}, {-1, 1.5}, {-2, 0}, {-1, -1.5}, {1, -1.5}},
                 {{0, 1, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {1, 0, 6}, {1, 6, 7}, {1, 7, 2}, {1, 2, 3}});
  DrawnMesh before = closed;
  const auto slit = meshops::unglue(before.mesh, before.between(0, 1));
  for (const Halfedge h : {slit.first, slit.second}) {
    const bool above = before.mesh.face_handle(before.mesh.opposite_halfedge_handle(h)) == Face(0);
    before.bend[before.mesh.edge_handle(h)] = {0, above ? 0.6 : -0.6};
  }
  return glue_figure("Glue closes a curve of two edges", before, slit.first, slit.second,
                     [](DrawnMesh& after, Marks&) { after.bend.clear(); });
}

std::string close_curve() {
  const Ring closed = ring(6, 0, 360, 0.95, 1.8);
  const DrawnMesh before = drawn_mesh(closed.places, closed.faces);
  DrawnMesh after = before;
  const auto effect = meshops::close_curve(after.mesh, before.boundary_between(6, 7));
  DrawnMesh back = after;
  meshops::open_curve(back.mesh, effect.face);
  require_same_counts(before, back);
  Marks hole, filled;
  for (const Halfedge h : after.mesh.fh_range(effect.face)) hole.add(after.mesh.edge_handle(h));
  filled.add(effect.face);
  return sheet_of("Close fills a curve with one face, open takes the face out", counted(before, hole),
                  {"close_curve", "open_curve"}, counted(after, filled));
}

std::string zip_curves() {
  Ring all = ring(6, 0, 360, 1.35, 2.0);
  all.places.push_back({0, 0});
  for (std::uint32_t i = 0; i < 6; ++i) {
    all.places.push_back(polar(60.0 * i, 0.85));
    all.faces.push_back({12, 13 + i, 13 + (i + 1) % 6});
  }
  const DrawnMesh before = drawn_mesh(all.places, all.faces);
  const Halfedge hole = before.boundary_between(6, 7), rim = before.boundary_between(13, 14);
  Marks curves, seam;
  std::vector<Halfedge> edges_of_seam;
  for (const Halfedge h : meshops::BoundaryCurve(before.mesh, hole)) edges_of_seam.push_back(h);
  for (const Halfedge h : edges_of_seam) seam.add(before.mesh.edge_handle(h));
  curves = seam;
  for (const Halfedge h : meshops::BoundaryCurve(before.mesh, rim)) curves.add(before.mesh.edge_handle(h));
  DrawnMesh after = before;
  meshops::zip_curves(after.mesh, hole, rim);
  DrawnMesh back = after;
  for (auto h = edges_of_seam.rbegin(); h != edges_of_seam.rend(); ++h) meshops::unglue(back.mesh, *h);
  require_same_counts(before, back);
  for (int i = 0; i < 6; ++i) after.move(Vertex(6 + i), polar(60.0 * i, 1.15));
  return sheet_of("Zip sews two curves of equal length together", counted(before, curves), {"zip_curves", "6 × unglue"},
                  counted(after, seam));
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

std::string remove_triangle() {
  const DrawnMesh before = drawn_mesh(
      {{-2, 0}, {0, 0}, {2, 0}, {-1, 1.3}, {1, 1.3}, {-3, 1.3}, {3, 1.3}, {-2, 2.6}, {0, 2.6}, {2, 2.6}},
      {{1, 4, 3}, {0, 1, 3}, {1, 2, 4}, {0, 3, 5}, {2, 6, 4}, {5, 3, 7}, {3, 8, 7}, {3, 4, 8}, {4, 9, 8}, {4, 6, 9}});
  DrawnMesh after = before;
  meshops::remove_triangle(after.mesh, Face(0));
  require_same_counts(before, filled_again(after));
  Marks triangle, corners;
  triangle.add(Face(0));
  triangle.add(Vertex(1));
  // Fans that met at one vertex lie slightly apart, each on its side.
  meshops::for_each_vertex(after.mesh, [&](Vertex v) {
    if (!(after.place(v) == before.place(Vertex(1)))) return;
    corners.add(v);
    bool left = false;
    for (const Vertex w : after.mesh.vv_range(v)) left = left || w == Vertex(3);
    after.move(v, {left ? -0.16 : 0.16, 0});
  });
  return sheet_of("Remove takes a triangle out; where the rest would touch itself a vertex becomes two",
                  counted(before, triangle), {"remove_triangle", "insert_triangle"}, counted(after, corners));
}

}  // namespace

std::span<const Figure> handle_figures() {
  static constexpr std::array figures = {Figure{"handle_create", create},
                                         Figure{"handle_glue_join", glue_join},
                                         Figure{"handle_glue_split_curve", glue_split_curve},
                                         Figure{"handle_glue_handle", glue_handle},
                                         Figure{"handle_glue_zip", glue_zip},
                                         Figure{"handle_glue_close", glue_close},
                                         Figure{"handle_close_curve", close_curve},
                                         Figure{"handle_zip_curves", zip_curves},
                                         Figure{"handle_remove_triangle", remove_triangle}};
  return figures;
}

}  // namespace figures
