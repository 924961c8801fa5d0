// CGAL makes OpenMesh's meshes graphs of Boost, and so do the views: one program can use both.
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/helpers.h>
#include <doctest/doctest.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <vector>

#include "meshops/front/engine.h"
#include "meshops/graph/boundary_graph.h"
#include "meshops/graph/dual_graph.h"
#include "meshops/graph/edge_map.h"
#include "meshops/graph/primal_graph.h"
#include "meshops/handle/create.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/topology/homology.h"
#include "meshops/topology/report.h"
#include "meshops/topology/tracker.h"

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;

namespace {

/// Returns squares in rows, and one square apart.
Mesh squares(int columns, int rows) {
  Mesh mesh;
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) mesh.add_vertex({float(x), float(y), 0});
  const auto at = [&](int x, int y) { return OpenMesh::VertexHandle(y * (columns + 1) + x); };
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      mesh.add_face(std::vector{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  std::vector<OpenMesh::VertexHandle> apart;
  for (int i = 0; i < 4; ++i) apart.push_back(mesh.add_vertex({float(9 + (i == 1 || i == 2)), float(i / 2), 0}));
  mesh.add_face(apart);
  return mesh;
}

template <typename Graph>
std::size_t component_count(const Graph& g) {
  std::vector<std::size_t> component(num_vertices(g));
  return boost::connected_components(g,
                                     boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, g)));
}

template <typename Graph, typename Weight>
std::vector<double> distances(const Graph& g, Weight weight) {
  std::vector<double> distance(num_vertices(g));
  boost::dijkstra_shortest_paths(g, OpenMesh::VertexHandle(0),
                                 boost::weight_map(weight).distance_map(
                                     boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, g))));
  return distance;
}

}  // namespace

TEST_SUITE("graph views together with CGAL") {
  TEST_CASE("an algorithm through CGAL's traits and through the views gives the same") {
    const Mesh mesh = squares(4, 3);
    const meshops::PrimalGraph primal(mesh);
    CHECK(component_count(primal) == 2);
    CHECK(component_count(meshops::DualGraph(mesh)) == 2);
    CHECK(component_count(meshops::BoundaryGraph(mesh)) == 2);
    const auto by_cgal = distances(mesh, get(boost::edge_weight, mesh));
    const auto by_view = distances(primal, meshops::length_map(mesh));
    CHECK(by_cgal == by_view);
    CHECK(by_view[19] == 7);
    std::vector<meshops::Halfedge> forest;
    boost::kruskal_minimum_spanning_tree(primal, std::back_inserter(forest),
                                         boost::weight_map(meshops::length_map(mesh)));
    CHECK(forest.size() == 22);
  }

  TEST_CASE("a mesh after operators is a valid halfedge graph for CGAL") {
    Mesh mesh;
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_halfedge_status();
    mesh.request_face_status();
    const auto boundary = [&] { return meshops::create_triangle(mesh).boundary; };
    const meshops::Halfedge a = boundary(), b = boundary(), c = boundary(), d = boundary();
    const auto valid = [&] {
      Mesh compact = mesh;
      compact.garbage_collection();
      return CGAL::is_valid_halfedge_graph(compact) && CGAL::is_valid_face_graph(compact);
    };
    meshops::glue(mesh, a, b);
    meshops::zip_curves(mesh, c, d);
    CHECK(valid());
    meshops::split_edge(mesh, a);
    const meshops::SplitEffect split = meshops::split_face(mesh, mesh.face_handle(a));
    CHECK_FALSE(meshops::flip_blocker(mesh, mesh.edge_handle(a)));
    const meshops::FlipEffect flipped = meshops::flip(mesh, mesh.edge_handle(a));
    CHECK(valid());
    meshops::undo(mesh, flipped);
    meshops::collapse(mesh, split.halfedge);
    meshops::unglue(mesh, a);
    CHECK(valid());
    CHECK(meshops::report(mesh).solid_components == 2);
    CHECK(meshops::homology(mesh).generators.empty());
  }
}
