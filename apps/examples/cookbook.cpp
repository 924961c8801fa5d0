// The recipes of docs/reference/operators.md, section 7, one after another on one mesh.
#include "meshops/meshops.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <cstdio>
#include <queue>
#include <utility>
#include <vector>

#include "rbpa/space/repair/mesh_holes.h"

using namespace meshops;

// Cut and removed elements are marked deleted, which needs status.
struct Mesh : OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble> {
  Mesh() {
    request_vertex_status();
    request_edge_status();
    request_halfedge_status();
    request_face_status();
    request_vertex_texcoords2D();
  }
};

namespace {

/// Returns a sheet of 12 by 8 squares, each cut in two, with waves, and a hump in its middle.
Mesh sheet() {
  constexpr std::uint32_t columns = 12, rows = 8;
  PolygonSoup soup;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * (columns + 1) + x, b = a + 1, d = a + columns + 1, c = d + 1;
      soup.add_face(std::array{a, b, c});
      soup.add_face(std::array{a, c, d});
    }
  soup.points = (columns + 1) * (rows + 1);
  Mesh mesh;
  build_mesh(mesh, soup);
  for (const Vertex v : mesh.vertices()) {
    const auto i = static_cast<std::uint32_t>(v.idx());
    const double x = i % (columns + 1), y = i / (columns + 1);
    const double height = 3 / (1 + ((x - 6) * (x - 6) + (y - 4) * (y - 4)) / 6);
    mesh.set_point(v, {x + 0.2 * std::sin(y), y + 0.2 * std::sin(1.3 * x), height});
  }
  return mesh;
}

/// Returns whether all vertices of a face are on the upper part of the hump.
bool is_high(const Mesh& mesh, Face f) {
  for (const Vertex v : mesh.fv_range(f))
    if (mesh.point(v)[2] < 1.5) return false;
  return true;
}

void print(const char* what, const Mesh& mesh) {
  const TopologyReport r = report(mesh);
  std::printf("%s: %zu faces, %zu pieces, %zu boundary curves\n", what, r.faces, r.components, r.boundary_curves);
}

// Cuts a patch out along the edges between its faces and others. Each vertex on the cut becomes two, at the same point.
template <typename IsInPatch>
void cut_out(Mesh& mesh, IsInPatch is_in_patch) {
  for_each_halfedge(mesh, [&](Halfedge h) {
    if (mesh.is_boundary(mesh.edge_handle(h))) return;
    const Face f = mesh.face_handle(h), beyond = mesh.face_handle(mesh.opposite_halfedge_handle(h));
    if (is_in_patch(f) && !is_in_patch(beyond)) unglue(mesh, h);
  });
}

// Fills holes so that no triangles cross: of the triangulations without crossings, it takes the one that turns least.
// Long holes stay open.
std::size_t fill_holes(Mesh& mesh, std::size_t longest) {
  std::vector<BoundaryCurve> holes = boundary_curves(mesh);
  std::erase_if(holes, [&](const BoundaryCurve& hole) { return hole.length() > longest; });
  const rbpa::FilledMesh filled = rbpa::fill_holes(mesh, holes);
  return static_cast<std::size_t>(
      std::ranges::count(filled.holes, rbpa::HoleOutcome::filled, &rbpa::HoleFill::outcome));
}

// Splits the longest edge first, and the parts again while they are too long: new vertices lie in the middle of their
// edges.
int split_long_edges(Mesh& mesh, double longest) {
  const auto length = [&](Edge e) { return get(length_map(mesh), mesh.halfedge_handle(e, 0)); };
  std::priority_queue<std::pair<double, int>> edges;
  const auto add = [&](Edge e) { edges.emplace(length(e), e.idx()); };
  for_each_edge(mesh, add);
  int splits = 0;
  while (!edges.empty() && edges.top().first > longest) {
    const Edge e(edges.top().second);
    edges.pop();
    if (split_edge_blocker(mesh, e)) continue;
    const SplitEdgeEffect split = split_edge(mesh, e);
    add(e);
    for (const Edge added : split.added.edges()) add(added);
    ++splits;
  }
  return splits;
}

// Runs Boost's algorithm of Dijkstra on the vertices and edges of the mesh, weighted by length.
std::vector<Vertex> shortest_path(const Mesh& mesh, Vertex from, Vertex to) {
  const PrimalGraph graph(mesh);
  std::vector<Vertex> before(num_vertices(graph));
  boost::dijkstra_shortest_paths(
      graph, from,
      boost::weight_map(length_map(mesh)).predecessor_map(by_index(before, get(boost::vertex_index, graph))));
  std::vector<Vertex> path = {to};
  while (path.back() != from) path.push_back(before[static_cast<std::size_t>(path.back().idx())]);
  std::reverse(path.begin(), path.end());
  return path;
}

// Returns a loop around each hole but one, and two loops for each handle. Given the lengths of the edges, the loops are
// short.
std::vector<Loop> short_loops(const Mesh& mesh) {
  std::vector<double> lengths(mesh.n_edges(), 0);
  for_each_edge(mesh, [&](Edge e) {
    lengths[static_cast<std::size_t>(e.idx())] = get(length_map(mesh), mesh.halfedge_handle(e, 0));
  });
  return homology(mesh, lengths).generators;
}

// Gives the new vertex the mean heat of the ends of the edge, and the mean of their texture coordinates.
template <typename Heat>
double split_between(Mesh& mesh, Edge e, Heat& heat) {
  return heat[split_edge(mesh, e, Interpolate(heat, mesh.vertex_texcoords2D_pph())).added.vertex];
}

// Flips each edge, and flips it back if that did not make it shorter. undo_to() the returned number undoes all of it.
std::size_t shorten_by_flips(History& history, const Mesh& mesh) {
  const auto length = [&](Edge e) { return get(length_map(mesh), mesh.halfedge_handle(e, 0)); };
  const std::size_t before = history.steps();
  for (const Edge e : live_edges(mesh)) {
    if (flip_blocker(mesh, e)) continue;
    const double old = length(e);
    history.flip(e);
    if (length(e) >= old) history.undo();
  }
  return before;
}

}  // namespace

int main() {
  Mesh mesh = sheet();
  print("sheet", mesh);

  cut_out(mesh, [&](Face f) { return is_high(mesh, f); });
  print("with a patch cut out", mesh);

  // Remove the patch, which leaves a hole.
  for (const Face f : live_faces(mesh))
    if (is_high(mesh, f)) remove_triangle(mesh, f);
  print("without the patch", mesh);

  const std::vector<Loop> loops = short_loops(mesh);
  std::printf("loops: %zu, of %zu edges\n", loops.size(), loops.front().size());

  // Cut open, the sheet is a disc; glued back, it is restored.
  const std::vector<UnglueEffect> cuts = cut_open(mesh, homology(mesh));
  print("cut open", mesh);
  glue_back(mesh, cuts);
  print("glued back", mesh);

  const std::vector<Vertex> around = shortest_path(mesh, Vertex(0), Vertex(116));
  std::printf("the way around the hole: %zu vertices\n", around.size());

  std::printf("holes filled: %zu\n", fill_holes(mesh, 20));
  print("filled", mesh);

  std::printf("edges split: %d\n", split_long_edges(mesh, 1.5));
  print("with short edges", mesh);

  History history(mesh);
  const std::size_t before = shorten_by_flips(history, mesh);
  std::printf("edges flipped: %s\n", history.steps() > before ? "some" : "none");
  history.undo_to(before);

  auto heat = OpenMesh::VProp<double>(mesh, "heat");
  heat[Vertex(0)] = 10;
  heat[Vertex(1)] = 30;
  std::printf("between 10 and 30: %g\n",
              split_between(mesh, mesh.edge_handle(mesh.find_halfedge(Vertex(0), Vertex(1))), heat));
}
