#include <array>
#include <boost/graph/iteration_macros.hpp>
#include <iterator>
#include <map>
#include <type_traits>
#include <utility>

#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "meshops/graph/boundary_graph.h"
#include "meshops/graph/dual_graph.h"
#include "meshops/graph/primal_graph.h"
#include "meshops/topology/homology.h"

namespace figures {
namespace {

/// Returns rows of triangles with one missing in the middle.
DrawnMesh patch() {
  constexpr std::uint32_t columns = 5, rows = 4;
  std::vector<Place> places;
  std::vector<Corners> faces;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) places.push_back({0.9 * x + (y % 2 == 1 ? 0.45 : 0), 0.8 * y});
  for (std::uint32_t y = 0; y + 1 < rows; ++y)
    for (std::uint32_t x = 0; x + 1 < columns; ++x) {
      const std::uint32_t a = y * columns + x, b = a + 1, c = a + columns, d = c + 1;
      if (y % 2 == 0) {
        faces.push_back({a, b, c});
        faces.push_back({b, d, c});
      } else {
        faces.push_back({a, b, d});
        if (y != 1 || x != 1) faces.push_back({a, d, c});
      }
    }
  return drawn_mesh(places, faces);
}

/// Draws the mesh in pale ink, and the nodes and edges of a view over it.
template <typename View, typename PlaceOf>
Panel view_panel(const DrawnMesh& drawn, const char* name, PlaceOf place_of) {
  Panel panel;
  panel.extent = drawn.all_places();
  panel.heading = name;
  const View view(drawn.mesh);
  const auto nodes = vertices(view);
  const auto links = edges(view);
  panel.caption = {std::to_string(std::distance(nodes.first, nodes.second)) + " vertices · " +
                   std::to_string(std::distance(links.first, links.second)) + " edges"};
  panel.more = [&drawn, place_of](Canvas& canvas, const Frame& frame) {
    for (const Face f : drawn.mesh.faces()) {
      std::vector<Segment> sides;
      for (const Halfedge h : drawn.mesh.fh_range(f)) sides.push_back(frame.of(drawn.segment(h)));
      canvas.outline(sides, color::pale_face);
    }
    for (const Edge e : drawn.mesh.edges())
      canvas.segment(frame.of(drawn.segment(drawn.mesh.halfedge_handle(e, 0))), {color::pale, 1.2});
    const View graph(drawn.mesh);
    const bool directed = std::is_same_v<View, meshops::BoundaryGraph>;
    BGL_FORALL_EDGES_T(h, graph, View) {
      const Place from = frame(place_of(source(h, graph))), to = frame(place_of(target(h, graph)));
      canvas.segment({from, to, {}}, {color::curve, 2});
      if (directed) canvas.head(0.5 * (from + to), to - from, color::curve, 9);
    }
    BGL_FORALL_VERTICES_T(v, graph, View) { canvas.dot(frame(place_of(v)), 3.8, color::touched); }
  };
  return panel;
}

std::string graph_views() {
  const DrawnMesh drawn = patch();
  const auto of_vertex = [&](Vertex v) { return drawn.place(v); };
  const auto of_face = [&](Face f) { return drawn.centroid(f); };
  return Sheet("One mesh as three graphs: vertices, faces, boundary")
      .row({view_panel<meshops::PrimalGraph>(drawn, "PrimalGraph", of_vertex),
            view_panel<meshops::DualGraph>(drawn, "DualGraph", of_face),
            view_panel<meshops::BoundaryGraph>(drawn, "BoundaryGraph", of_vertex)})
      .svg();
}

constexpr std::uint32_t torus_columns = 7, torus_rows = 6;
constexpr double torus_step = 0.62;

/// Returns a torus as a rectangle whose opposite sides are one; vertex 0 lies in the middle.
DrawnMesh torus() {
  constexpr std::uint32_t columns = torus_columns, rows = torus_rows;
  std::vector<Place> places;
  std::vector<std::uint32_t> vertex_of;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first, number;
  const auto add = [&](std::uint32_t x, std::uint32_t y) {
    const auto place = static_cast<std::uint32_t>(places.size());
    if (!number.try_emplace({x, y}, place).second) return;
    places.push_back({torus_step * x, torus_step * y});
    vertex_of.push_back(first.try_emplace({x % columns, y % rows}, place).first->second);
  };
  add(columns / 2, rows / 2);
  for (std::uint32_t y = 0; y <= rows; ++y)
    for (std::uint32_t x = 0; x <= columns; ++x) add(x, y);
  std::vector<Corners> faces;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const auto at = [&](std::uint32_t dx, std::uint32_t dy) { return number.at({x + dx, y + dy}); };
      faces.push_back({at(0, 0), at(1, 0), at(1, 1)});
      faces.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  return drawn_mesh(places, faces, vertex_of);
}

/// Draws the sides of the rectangle: sides with equally many heads are one.
void draw_sides(Canvas& canvas, const Frame& frame) {
  const double right = torus_step * torus_columns, top = torus_step * torus_rows;
  const auto side = [&](Place from, Place to, bool twice) {
    const Segment s = frame.of({from, to, {}});
    canvas.segment(s, {color::text, 1.6});
    const Place along = direction(s.to - s.from);
    // Off the middle, because a loop may cross there.
    const Place at = s.from + 0.3 * (s.to - s.from);
    canvas.head(at, along, color::text, 11);
    if (twice) canvas.head(at + 9 * along, along, color::text, 11);
  };
  for (const double y : {0.0, top}) side({0, y}, {right, y}, false);
  for (const double x : {0.0, right}) side({x, 0}, {x, top}, true);
}

/// Draws an edge on both sides, if they lie apart.
void draw_edge(Canvas& canvas, const Frame& frame, const DrawnMesh& drawn, Halfedge h, std::string_view ink,
               bool head) {
  const Segment left = frame.of(drawn.segment(h));
  const Segment right = frame.of(drawn.segment(drawn.mesh.opposite_halfedge_handle(h)).reversed());
  for (const Segment& s : {left, right}) {
    canvas.segment(s, {ink, 3.2});
    if (head) canvas.head(s.middle(), s.to - s.from, ink, 11);
    if (left.from == right.from && left.to == right.to) break;
  }
}

std::string homology() {
  const DrawnMesh drawn = torus();
  const meshops::Homology found = meshops::homology(drawn.mesh);
  Panel loops = counted(drawn), cut = counted(drawn);
  loops.heading = std::to_string(found.generators.size()) + " generators";
  loops.more = [&](Canvas& canvas, const Frame& frame) {
    draw_sides(canvas, frame);
    bool first = true;
    for (const meshops::Loop& loop : found.generators) {
      for (const Halfedge h : loop) draw_edge(canvas, frame, drawn, h, first ? color::touched : color::curve, true);
      first = false;
    }
  };
  cut.heading = "cut graph: " + std::to_string(found.cut_graph.size()) + " edges";
  cut.more = [&](Canvas& canvas, const Frame& frame) {
    draw_sides(canvas, frame);
    for (const Edge e : found.cut_graph)
      draw_edge(canvas, frame, drawn, drawn.mesh.halfedge_handle(e, 0), color::touched, false);
  };
  return Sheet("Generators of the homology of a torus, and edges along which it becomes a disc")
      .row({loops, cut})
      .svg();
}

}  // namespace

std::span<const Figure> topology_figures() {
  static constexpr std::array figures = {Figure{"graph_views", graph_views}, Figure{"homology", homology}};
  return figures;
}

}  // namespace figures
