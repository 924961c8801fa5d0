#include "drawings/drawn_complex.h"

#include "meshops/core/live.h"

namespace figures {
namespace {

Place place_of(const rbpa::Mesh& mesh, Vertex v) { return {mesh.point(v)[0], mesh.point(v)[1]}; }

Segment segment_of(const rbpa::Mesh& mesh, Halfedge h) {
  return {place_of(mesh, mesh.from_vertex_handle(h)), place_of(mesh, mesh.to_vertex_handle(h)), {}};
}

}  // namespace

Panel panel_over(const Points& points, std::string heading, std::vector<std::string> caption) {
  Panel panel;
  panel.heading = std::move(heading);
  panel.caption = std::move(caption);
  for (const rbpa::Point& p : points) panel.extent.push_back(figures::place_of(p));
  return panel;
}

void draw_points(Canvas& canvas, const Frame& frame, std::span<const rbpa::Point> points, double radius,
                 std::string_view ink) {
  std::vector<Place> places;
  for (const rbpa::Point& p : points) places.push_back(frame(figures::place_of(p)));
  canvas.dots(places, radius, ink);
}

void draw_complex(Canvas& canvas, const Frame& frame, const rbpa::SolidAlphaComplex& complex, double width) {
  const rbpa::Mesh& mesh = complex.mesh;
  std::vector<std::vector<Place>> faces;
  meshops::for_each_face(mesh, [&](Face f) {
    faces.emplace_back();
    for (const Vertex v : mesh.fv_range(f)) faces.back().push_back(frame(place_of(mesh, v)));
  });
  std::vector<Segment> inner, boundary;
  meshops::for_each_edge(mesh, [&](Edge e) {
    (mesh.is_boundary(e) ? boundary : inner).push_back(frame.of(segment_of(mesh, mesh.halfedge_handle(e, 0))));
  });
  canvas.region(faces, color::face);
  canvas.segments(inner, {color::inner, width / 2});
  canvas.segments(boundary, {color::curve, width});
}

void draw_solid(Canvas& canvas, const Frame& frame, const Points& points, std::span<const rbpa::Polygon> solid,
                double width) {
  std::vector<std::vector<Place>> rings;
  const auto add = [&](const rbpa::Ring& ring) {
    rings.emplace_back();
    for (const std::uint32_t i : ring.points) rings.back().push_back(frame(figures::place_of(points[i])));
  };
  for (const rbpa::Polygon& polygon : solid) {
    add(polygon.shell);
    for (const rbpa::Ring& hole : polygon.holes) add(hole);
  }
  canvas.region(rings, color::face);
  canvas.closed_lines(rings, {color::curve, width});
}

}  // namespace figures
