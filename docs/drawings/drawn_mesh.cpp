#include "drawings/drawn_mesh.h"

#include <algorithm>
#include <stdexcept>

#include "meshops/core/live.h"
#include "meshops/topology/build_mesh.h"

namespace figures {
namespace {

void draw_faces(Canvas& canvas, const Frame& frame, const DrawnMesh& drawn, const Marks& marks) {
  meshops::for_each_face(drawn.mesh, [&](Face f) {
    std::vector<Segment> sides;
    for (const Halfedge h : drawn.mesh.fh_range(f)) sides.push_back(frame.of(drawn.segment(h)));
    canvas.outline(sides, marks.faces.contains(f) ? color::touched_face : color::face);
  });
}

/// Draws an inner edge once, or once on each side if the sides lie apart; arrow heads then show how they fit.
void draw_inner_edge(Canvas& canvas, const Frame& frame, const DrawnMesh& drawn, Edge e, bool touched) {
  const Halfedge h = drawn.mesh.halfedge_handle(e, 0);
  const Segment one = frame.of(drawn.segment(h)), other = frame.of(drawn.segment(Halfedge(h.idx() ^ 1)).reversed());
  const std::string_view ink = touched ? color::touched : color::inner;
  const double width = touched ? 2.6 : 1.2;
  canvas.segment(one, {ink, width});
  if (one.from == other.from && one.to == other.to) return;
  canvas.segment(other, {ink, width});
  for (const Segment& side : {one, other})
    for (const double at : {-3.5, 3.5})
      if (touched) canvas.head(side.middle() + at * direction(side.to - side.from), side.to - side.from, ink, 9);
}

void draw_boundary(Canvas& canvas, const Frame& frame, const DrawnMesh& drawn, const Marks& marks) {
  meshops::for_each_halfedge(drawn.mesh, [&](Halfedge h) {
    if (!drawn.mesh.is_boundary(h)) return;
    const Segment s = frame.of(drawn.segment(h));
    const auto ink = marks.edges.contains(drawn.mesh.edge_handle(h)) ? color::touched : color::curve;
    canvas.segment(s, {ink, 2.6});
    if (length(s.to - s.from) > 20) canvas.head(s.middle(), s.to - s.from, ink, 9);
  });
}

void draw_vertices(Canvas& canvas, const Frame& frame, const DrawnMesh& drawn, const Marks& marks) {
  const auto dot = [&](Place at, Vertex v) {
    const bool touched = marks.vertices.contains(v);
    canvas.dot(frame(at), touched ? 4.6 : 3.4, touched ? color::touched : color::text);
  };
  meshops::for_each_vertex(drawn.mesh, [&](Vertex v) {
    if (drawn.mesh.is_isolated(v)) dot(drawn.place(v), v);
    std::vector<Place> dotted;
    for (const Halfedge h : drawn.mesh.vih_range(v)) {
      const Place at = drawn.segment(h).to;
      if (std::find(dotted.begin(), dotted.end(), at) != dotted.end()) continue;
      dot(at, v);
      dotted.push_back(at);
    }
  });
}

}  // namespace

Segment DrawnMesh::segment(Halfedge h) const {
  if (mesh.is_boundary(h)) return segment(mesh.opposite_halfedge_handle(h)).reversed();
  const auto corner = [&](Halfedge into) {
    const auto found = apart.find(into);
    return found != apart.end() ? found->second : place(mesh.to_vertex_handle(into));
  };
  Segment s{corner(mesh.prev_halfedge_handle(h)), corner(h), {}};
  if (const auto found = bend.find(mesh.edge_handle(h)); found != bend.end()) s.bend = found->second;
  return s;
}

Place DrawnMesh::centroid(Face f) const {
  Place sum;
  int corners = 0;
  for (const Halfedge h : mesh.fh_range(f)) {
    sum = sum + segment(h).to;
    ++corners;
  }
  return (1.0 / corners) * sum;
}

Halfedge DrawnMesh::between(int from, int to) const {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  if (!h.is_valid()) throw std::logic_error("no edge between " + std::to_string(from) + " and " + std::to_string(to));
  return h;
}

Halfedge DrawnMesh::boundary_between(int a, int b) const {
  const Halfedge h = between(a, b), other = mesh.opposite_halfedge_handle(h);
  if (mesh.is_boundary(h)) return h;
  if (mesh.is_boundary(other)) return other;
  throw std::logic_error("an inner edge between " + std::to_string(a) + " and " + std::to_string(b));
}

std::vector<Place> DrawnMesh::all_places() const {
  std::vector<Place> places;
  meshops::for_each_vertex(mesh, [&](Vertex v) { places.push_back(place(v)); });
  meshops::for_each_face(mesh, [&](Face f) {
    for (const Halfedge h : mesh.fh_range(f)) places.push_back(segment(h).to);
  });
  return places;
}

DrawnMesh drawn_mesh(const std::vector<Place>& places, const std::vector<Corners>& faces) {
  meshops::PolygonSoup soup;
  soup.points = places.size();
  for (const Corners& face : faces) soup.add_face(face);
  DrawnMesh drawn;
  const auto point_of_vertex = meshops::build_mesh(drawn.mesh, soup);
  for (std::size_t v = 0; v < point_of_vertex.size(); ++v)
    drawn.move(Vertex(static_cast<int>(v)), places[point_of_vertex[v]]);
  return drawn;
}

Ring ring(std::uint32_t quads, double from, double to, double inner_radius, double outer_radius) {
  Ring made;
  const bool closed = to - from > 359;
  const std::uint32_t n = closed ? quads : quads + 1;
  for (const double radius : {outer_radius, inner_radius})
    for (std::uint32_t i = 0; i < n; ++i) made.places.push_back(polar(from + (to - from) * i / quads, radius));
  for (std::uint32_t i = 0; i < quads; ++i) {
    const std::uint32_t j = (i + 1) % n;
    made.faces.push_back({i, j, n + i});
    made.faces.push_back({j, n + j, n + i});
  }
  return made;
}

void draw(Canvas& canvas, const Frame& frame, const DrawnMesh& drawn, const Marks& marks) {
  draw_faces(canvas, frame, drawn, marks);
  // Draw touched elements above the others.
  for (const bool touched : {false, true})
    meshops::for_each_edge(drawn.mesh, [&](Edge e) {
      if (!drawn.mesh.is_boundary(e) && marks.edges.contains(e) == touched)
        draw_inner_edge(canvas, frame, drawn, e, touched);
    });
  draw_boundary(canvas, frame, drawn, marks);
  draw_vertices(canvas, frame, drawn, marks);
  for (const Marks::Label& label : marks.labels)
    canvas.text(frame(label.at) + Place{0, 5}, label.words, Lettering::italic);
}

}  // namespace figures
