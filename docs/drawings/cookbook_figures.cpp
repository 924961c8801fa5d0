#include <array>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <queue>

#include "drawings/figures.h"
#include "drawings/sheet.h"
#include "meshops/core/live.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/graph/by_index.h"
#include "meshops/graph/edge_map.h"
#include "meshops/graph/primal_graph.h"
#include "meshops/handle/close_curve.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/unglue.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/triangulate_face.h"
#include "meshops/topology/homology.h"

namespace figures {
namespace {

constexpr std::uint32_t columns = 11, rows = 7;

/// Returns the sheet of the cookbook, seen from above: squares cut in two, with waves, and a hump that only lengths and
/// areas show.
DrawnMesh waved_sheet() {
  std::vector<Place> places;
  std::vector<Corners> faces;
  for (std::uint32_t y = 0; y <= rows; ++y)
    for (std::uint32_t x = 0; x <= columns; ++x)
      places.push_back({0.5 * x + 0.1 * std::sin(y), 0.5 * y + 0.1 * std::sin(1.3 * x)});
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * (columns + 1) + x, b = a + 1, d = a + columns + 1, c = d + 1;
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  DrawnMesh drawn = drawn_mesh(places, faces);
  for (const Vertex v : drawn.mesh.vertices()) {
    const Place p = drawn.place(v) - Place{2.75, 1.75};
    drawn.mesh.set_point(v, {p.x + 2.75, p.y + 1.75, 1.5 / (1 + 1.5 * (p.x * p.x + p.y * p.y))});
  }
  return drawn;
}

bool is_in_patch(const DrawnMesh& drawn, Face f) {
  for (const Vertex v : drawn.mesh.fv_range(f))
    if (drawn.mesh.point(v)[2] < 0.62) return false;
  return true;
}

std::vector<Face> patch_of(const DrawnMesh& drawn) {
  std::vector<Face> patch;
  meshops::for_each_face(drawn.mesh, [&](Face f) {
    if (is_in_patch(drawn, f)) patch.push_back(f);
  });
  return patch;
}

void cut_out(DrawnMesh& drawn) {
  meshops::for_each_halfedge(drawn.mesh, [&](Halfedge h) {
    const Mesh& mesh = drawn.mesh;
    if (mesh.is_boundary(mesh.edge_handle(h))) return;
    const Face beyond = mesh.face_handle(mesh.opposite_halfedge_handle(h));
    if (is_in_patch(drawn, mesh.face_handle(h)) && !is_in_patch(drawn, beyond)) meshops::unglue(drawn.mesh, h);
  });
}

Panel headed(const DrawnMesh& drawn, const Marks& marks, std::string heading) {
  Panel panel = counted(drawn, marks);
  panel.heading = std::move(heading);
  return panel;
}

Panel lifted_patch(const DrawnMesh& cut, const std::vector<Face>& patch) {
  DrawnMesh apart = cut;
  Marks marks;
  std::set<Vertex> lifted;
  for (const Face f : patch) {
    marks.add(f);
    for (const Vertex v : cut.mesh.fv_range(f)) lifted.insert(v);
  }
  for (const Vertex v : lifted) apart.move(v, cut.place(v) + Place{4.3, 0});
  return headed(apart, marks, "unglue: a patch is cut out");
}

Panel filled_hole(DrawnMesh& drawn) {
  Marks marks;
  for (const meshops::BoundaryCurve& hole : meshops::boundary_curves(drawn.mesh)) {
    if (hole.length() > 2 * columns) continue;
    const Face face = meshops::close_curve(drawn.mesh, hole.front()).face;
    marks.add(face);
    for (const Face f : meshops::triangulate_face(drawn.mesh, face).faces) marks.add(f);
  }
  return headed(drawn, marks, "close_curve, triangulate_face");
}

Panel short_edges(DrawnMesh drawn, double longest) {
  std::priority_queue<std::pair<double, int>> edges;
  const auto add = [&](Edge e) {
    edges.emplace(get(meshops::length_map(drawn.mesh), drawn.mesh.halfedge_handle(e, 0)), e.idx());
  };
  meshops::for_each_edge(drawn.mesh, add);
  Marks marks;
  while (edges.top().first > longest) {
    const Edge e(edges.top().second);
    edges.pop();
    const auto split = meshops::split_edge(drawn.mesh, e);
    marks.add(split.added.vertex);
    add(e);
    for (const Edge added : split.added.edges()) add(added);
  }
  return headed(drawn, marks, "split_edge, the longest first");
}

Panel loop_around(const DrawnMesh& drawn) {
  std::vector<double> lengths(drawn.mesh.n_edges(), 0);
  meshops::for_each_edge(drawn.mesh, [&](Edge e) {
    lengths[static_cast<std::size_t>(e.idx())] = get(meshops::length_map(drawn.mesh), drawn.mesh.halfedge_handle(e, 0));
  });
  Marks marks;
  for (const meshops::Loop& loop : meshops::homology(drawn.mesh, lengths).generators)
    for (const Halfedge h : loop) marks.add(drawn.mesh.edge_handle(h));
  return headed(drawn, marks, "homology: a loop around the hole");
}

Panel way_around(const DrawnMesh& drawn) {
  const meshops::PrimalGraph graph(drawn.mesh);
  std::vector<Vertex> before(num_vertices(graph));
  const Vertex from(0), to((columns + 1) * (rows + 1) - 1);
  boost::dijkstra_shortest_paths(graph, from,
                                 boost::weight_map(meshops::length_map(drawn.mesh))
                                     .predecessor_map(meshops::by_index(before, get(boost::vertex_index, graph))));
  Marks marks;
  marks.add(to);
  for (Vertex v = to; v != from; v = before[static_cast<std::size_t>(v.idx())]) {
    const Vertex next = before[static_cast<std::size_t>(v.idx())];
    marks.add(next);
    marks.add(drawn.mesh.edge_handle(drawn.between(v.idx(), next.idx())));
  }
  return headed(drawn, marks, "the shortest way, by Boost");
}

std::string cookbook() {
  DrawnMesh drawn = waved_sheet();
  const std::vector<Face> patch = patch_of(drawn);
  cut_out(drawn);
  const Panel lifted = lifted_patch(drawn, patch);
  for (const Face f : patch) meshops::remove_triangle(drawn.mesh, f);
  const Panel loop = loop_around(drawn), way = way_around(drawn);
  const Panel filled = filled_hole(drawn);
  return Sheet("The recipes of the cookbook, on one sheet")
      .row({lifted})
      .row({loop, way})
      .row({filled, short_edges(drawn, 0.75)})
      .svg();
}

}  // namespace

std::span<const Figure> cookbook_figures() {
  static constexpr std::array figures = {Figure{"cookbook", cookbook}};
  return figures;
}

}  // namespace figures
