// Subdivision of triangle meshes by splits and flips: Loop's scheme makes four triangles of one, the √3 scheme three.
// Sources: Loop, Smooth subdivision surfaces based on triangles (1987); Kobbelt, √3-subdivision (2000).
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>
#include <vector>

#include "meshops/meshops.h"

using namespace meshops;
using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using Point = Mesh::Point;

namespace {

/// Returns (1 − α) v + α m for each vertex v, where m is the mean of its neighbors and α = weight(degree). On the
/// boundary, m is the mean of the two neighbors there, and α is `on_boundary`.
template <typename Weight>
std::vector<Point> smoothed(const Mesh& mesh, double on_boundary, Weight weight) {
  std::vector<Point> points;
  for (const Vertex v : mesh.vertices()) {
    Point sum(0, 0, 0);
    unsigned count = 0;
    for (const Halfedge h : mesh.voh_range(v)) {
      if (mesh.is_boundary(v) && !mesh.is_boundary(mesh.edge_handle(h))) continue;
      sum += mesh.point(mesh.to_vertex_handle(h));
      ++count;
    }
    const double alpha = mesh.is_boundary(v) ? on_boundary : weight(count);
    points.push_back(mesh.point(v) * (1 - alpha) + sum * (alpha / std::max(count, 1U)));
  }
  return points;
}

void subdivide_by_loop(Mesh& mesh) {
  const std::vector<Point> old = smoothed(mesh, 0.25, [](unsigned n) {
    const double a = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n);
    return 0.625 - a * a;
  });
  std::vector<Point> middles;
  for (const Edge e : mesh.edges()) {
    Point& middle = middles.emplace_back(mesh.calc_edge_midpoint(e));
    if (mesh.is_boundary(e)) continue;
    middle *= 0.75;
    for (const unsigned side : {0U, 1U})
      middle += mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(mesh.halfedge_handle(e, side)))) / 8;
  }
  std::vector<Edge> across;  // from a new vertex to what was the apex of a triangle
  for (std::size_t e = 0; e < middles.size(); ++e) {
    const SplitEdgeEffect effect = split_edge(mesh, Edge(static_cast<int>(e)));
    mesh.set_point(effect.added.vertex, middles[e]);
    for (const Edge added : effect.added.edges())
      if (added != effect.added.edge[0]) across.push_back(added);
  }
  const auto is_old = [&](Vertex v) { return static_cast<std::size_t>(v.idx()) < old.size(); };
  for (const Edge e : across) {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    if (is_old(mesh.from_vertex_handle(h)) != is_old(mesh.to_vertex_handle(h))) flip(mesh, e);
  }
  for (std::size_t v = 0; v < old.size(); ++v) mesh.set_point(Vertex(static_cast<int>(v)), old[v]);
}

/// Boundary edges and their vertices stay as they are.
void subdivide_by_sqrt3(Mesh& mesh) {
  const std::vector<Point> old =
      smoothed(mesh, 0, [](unsigned n) { return (4 - 2 * std::cos(2 * std::numbers::pi / n)) / 9; });
  const auto edges = mesh.n_edges(), faces = mesh.n_faces();
  for (std::size_t f = 0; f < faces; ++f) split_face(mesh, Face(static_cast<int>(f)));  // at the centroid
  for (std::size_t e = 0; e < edges; ++e)
    if (const Edge edge(static_cast<int>(e)); !mesh.is_boundary(edge)) flip(mesh, edge);
  for (std::size_t v = 0; v < old.size(); ++v) mesh.set_point(Vertex(static_cast<int>(v)), old[v]);
}

void show(const char* what, std::size_t triangles, void (*subdivide)(Mesh&)) {
  Mesh mesh;
  for (const Point& p : {Point(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}) mesh.add_vertex(p);
  const std::array<std::array<int, 3>, 8> octahedron{
      {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}}};
  for (const auto& [a, b, c] : std::span(octahedron).first(triangles)) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  request_status(mesh);
  for (int times = 0; times < 3; ++times) subdivide(mesh);
  std::size_t irregular = 0;
  for (const Vertex v : mesh.vertices()) irregular += !mesh.is_boundary(v) && mesh.valence(v) != 6;
  const TopologyReport r = report(mesh);
  std::printf("%s: %zu triangles, Euler characteristic %ld, inner degrees other than 6: %zu, a corner at %.3f\n", what,
              r.faces, r.euler() - static_cast<long>(r.isolated), irregular, mesh.point(Vertex(2)).norm());
}

}  // namespace

int main() {
  show("Loop, octahedron", 8, subdivide_by_loop);
  show("Loop, half of it", 4, subdivide_by_loop);
  show("sqrt3, octahedron", 8, subdivide_by_sqrt3);
}
