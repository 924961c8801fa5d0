// Boost's graph algorithms on a mesh, through the views of meshops/graph.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/edmonds_karp_max_flow.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <cstdio>
#include <iterator>
#include <vector>

#include "meshops/graph/boundary_graph.h"
#include "meshops/graph/by_index.h"
#include "meshops/graph/dual_graph.h"
#include "meshops/graph/edge_map.h"
#include "meshops/graph/primal_graph.h"

using namespace meshops;
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

namespace {

/// Returns three by two unit squares, each cut into two triangles along its rising diagonal, and a separate triangle.
///
///     8--9-10-11
///     | /| /| /|
///     4--5--6--7      14
///     | /| /| /|      | \.
///     0--1--2--3     12--13
Mesh small_mesh() {
  Mesh mesh;
  for (int y = 0; y <= 2; ++y)
    for (int x = 0; x <= 3; ++x) mesh.add_vertex({double(x), double(y), 0});
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) {
      const int corner = 4 * y + x;
      const Vertex a(corner), b(corner + 1), c(corner + 5), d(corner + 4);
      mesh.add_face(a, b, c);
      mesh.add_face(a, c, d);
    }
  mesh.add_face(mesh.add_vertex({5, 0, 0}), mesh.add_vertex({6, 0, 0}), mesh.add_vertex({5, 1, 0}));
  return mesh;
}

template <typename Graph>
std::size_t component_count(Graph graph) {
  std::vector<std::size_t> component(num_vertices(graph));
  return boost::connected_components(graph, by_index(component, get(boost::vertex_index, graph)));
}

}  // namespace

int main() {
  const Mesh mesh = small_mesh();
  const PrimalGraph primal(mesh);  // vertices and edges
  const DualGraph dual(mesh);      // faces, joined across inner edges
  const BoundaryGraph boundary(mesh);
  const Vertex first(0), last(10);

  std::printf("components: %zu by vertices, %zu by faces\n", component_count(primal), component_count(dual));
  std::printf("boundary curves: %zu\n", component_count(boundary));

  // Find the shortest path along edges, weighted by the distances of the points.
  const auto length = length_map(mesh);
  std::vector<double> distance(num_vertices(primal));
  std::vector<Vertex> before(num_vertices(primal));
  boost::dijkstra_shortest_paths(primal, first,
                                 boost::weight_map(length)
                                     .distance_map(by_index(distance, get(boost::vertex_index, primal)))
                                     .predecessor_map(by_index(before, get(boost::vertex_index, primal))));
  std::printf("distance from 0 to 10: %.3f, the way back:", distance[10]);
  for (Vertex v = last; v != first; v = before[static_cast<std::size_t>(v.idx())]) std::printf(" %d", v.idx());
  std::printf(" 0\n");

  // Find a shortest spanning forest of all vertices, as one halfedge of each edge.
  std::vector<Halfedge> forest;
  boost::kruskal_minimum_spanning_tree(primal, std::back_inserter(forest), boost::weight_map(length));
  double total = 0;
  for (const Halfedge h : forest) total += get(length, h);
  std::printf("spanning forest: %zu edges of total length %.3f\n", forest.size(), total);

  // Count the edges to cross from a face to each other.
  std::vector<int> crossed(num_vertices(dual), 0);
  boost::breadth_first_search(dual, Face(0),
                              boost::visitor(boost::make_bfs_visitor(boost::record_distances(
                                  by_index(crossed, get(boost::vertex_index, dual)), boost::on_tree_edge()))));
  std::printf("from face 0 to face 11: %d edges crossed\n", crossed[11]);

  // Count the paths between two vertices that have no edge in common: a maximum flow with capacity one.
  auto both_ways = directed(primal);
  std::vector<int> residual(num_edges(both_ways));
  const auto one = edge_map([](Edge) { return 1; });
  const auto left = by_index(residual, get(boost::edge_index, both_ways));
  const int ways =
      boost::edmonds_karp_max_flow(both_ways, first, last, boost::capacity_map(one).residual_capacity_map(left));
  std::printf("ways from 0 to 10 without a common edge: %d\n", ways);
}
