#include "meshops/graph/graph_view.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "graph/support.h"
#include "meshops/core/live_range.h"
#include "meshops/graph/boundary_graph.h"
#include "meshops/graph/dual_graph.h"
#include "meshops/graph/edge_map.h"
#include "meshops/graph/primal_graph.h"
#include "meshops/stellar/triangle_area.h"

using namespace meshops;
using namespace meshops::test;

template struct meshops::test::ViewConcepts<PrimalGraph>;
template struct meshops::test::ViewConcepts<DualGraph>;
template struct meshops::test::ViewConcepts<BoundaryGraph>;
using DirectedPrimal = decltype(directed(std::declval<PrimalGraph>()));
using DirectedDual = decltype(directed(std::declval<DualGraph>()));
template struct meshops::test::ViewConcepts<DirectedPrimal>;
template struct meshops::test::ViewConcepts<DirectedDual>;
BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<DirectedPrimal, Halfedge, boost::edge_reverse_t>));
BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<DirectedDual, Halfedge, boost::edge_reverse_t>));
using Lengths = decltype(length_map(std::declval<const TestMesh&>()));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<Lengths, Halfedge>));
static_assert(boost::is_undirected_graph<PrimalGraph>::value && boost::is_directed_graph<DirectedPrimal>::value);
static_assert(sizeof(PrimalGraph) == sizeof(void*) && std::is_trivially_copyable_v<PrimalGraph>);
// A view of a temporary would dangle.
template <typename T>
concept HasRange = requires(T mesh) {
  live_faces(std::forward<T>(mesh));
};
template <typename T>
concept HasLengths = requires(T mesh) {
  length_map(std::forward<T>(mesh));
};
static_assert(HasRange<const TestMesh&> && !HasRange<TestMesh> && HasLengths<const TestMesh&> && !HasLengths<TestMesh>);
static_assert(!std::is_constructible_v<PrimalGraph, TestMesh>);
static_assert(!std::is_constructible_v<TriangleArea<TestMesh>, TestMesh>);

namespace {

/// Compares incidences counted from the list of edges alone with those that the nodes list.
template <typename Graph>
void check_incidence(const Graph& g) {
  const bool both_ways = boost::is_directed(g);
  using Node = typename Graph::vertex_descriptor;
  std::map<Node, std::multiset<Halfedge>> leaving, arriving;
  std::map<Node, std::multiset<Node>> neighbors;
  for (const Node v : nodes_of(g)) leaving[v], arriving[v], neighbors[v];
  const auto add = [&](Halfedge h) {
    REQUIRE(leaving.contains(source(h, g)));
    REQUIRE(leaving.contains(target(h, g)));
    leaving[source(h, g)].insert(h);
    arriving[target(h, g)].insert(h);
    neighbors[source(h, g)].insert(target(h, g));
  };
  for (const Halfedge h : edges_of(g)) {
    add(h);
    if (!both_ways) add(Halfedge(h.idx() ^ 1));
  }
  for (const auto& [v, out] : leaving) {
    const auto o = out_edges(v, g);
    const auto i = in_edges(v, g);
    const auto a = adjacent_vertices(v, g);
    CHECK(std::multiset<Halfedge>(o.first, o.second) == out);
    CHECK(std::multiset<Halfedge>(i.first, i.second) == arriving[v]);
    CHECK(std::multiset<Node>(a.first, a.second) == neighbors[v]);
    CHECK(out_degree(v, g) == out.size());
    CHECK(in_degree(v, g) == out.size());
    CHECK(degree(v, g) == (both_ways ? 2 : 1) * out.size());
  }
}

/// Checks that storage of num_…() entries has a place for every index, and that the last place is used.
template <typename Graph>
void check_indices(const Graph& g) {
  std::size_t vertex_bound = 0, edge_bound = 0;
  for (const auto v : nodes_of(g)) vertex_bound = std::max(vertex_bound, get(boost::vertex_index, g, v) + 1);
  std::set<std::size_t> indices;
  for (const Halfedge h : edges_of(g)) {
    CHECK(indices.insert(get(boost::edge_index, g, h)).second);
    edge_bound = std::max(edge_bound, get(get(boost::edge_index, g), h) + 1);
  }
  CHECK(num_vertices(g) == vertex_bound);
  CHECK(num_edges(g) == edge_bound);
}

template <typename Graph>
void check_view(const Graph& g) {
  check_incidence(g);
  check_incidence(directed(g));
  check_indices(g);
  check_indices(directed(g));
  CHECK(edges_of(directed(g)).size() == 2 * edges_of(g).size());
}

}  // namespace

TEST_SUITE("graph view") {
  TEST_CASE("a view lists every live element of its kind once, in ascending order") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      CAPTURE(specimen.name);
      std::vector<Vertex> all, on_boundary;
      std::vector<Halfedge> sides, inner, boundary;
      std::vector<Face> faces;
      for_each_vertex(mesh, [&](Vertex v) {
        all.push_back(v);
        if (!mesh.is_isolated(v) && mesh.is_boundary(v)) on_boundary.push_back(v);
      });
      for_each_edge(mesh, [&](Edge e) {
        sides.push_back(mesh.halfedge_handle(e, 0));
        if (!mesh.is_boundary(e)) inner.push_back(sides.back());
      });
      for_each_halfedge(mesh, [&](Halfedge h) {
        if (mesh.is_boundary(h)) boundary.push_back(h);
      });
      for_each_face(mesh, [&](Face f) { faces.push_back(f); });
      CHECK(nodes_of(PrimalGraph(mesh)) == all);
      CHECK(edges_of(PrimalGraph(mesh)) == sides);
      CHECK(nodes_of(DualGraph(mesh)) == faces);
      CHECK(edges_of(DualGraph(mesh)) == inner);
      CHECK(nodes_of(BoundaryGraph(mesh)) == on_boundary);
      CHECK(edges_of(BoundaryGraph(mesh)) == boundary);
    });
  }

  TEST_CASE("the edges at a node are those in the list of edges") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      CAPTURE(specimen.name);
      check_view(PrimalGraph(mesh));
      check_view(DualGraph(mesh));
      check_view(BoundaryGraph(mesh));
    });
  }

  TEST_CASE("source and target follow the halfedge") {
    TestMesh mesh;
    add_triangles(mesh, 4, {{0, 1, 2}, {0, 2, 3}});
    const Halfedge diagonal = mesh.find_halfedge(Vertex(2), Vertex(0));
    CHECK(source(diagonal, PrimalGraph(mesh)) == Vertex(2));
    CHECK(target(diagonal, PrimalGraph(mesh)) == Vertex(0));
    CHECK(source(diagonal, DualGraph(mesh)) == Face(0));
    CHECK(target(diagonal, DualGraph(mesh)) == Face(1));
    const Halfedge rim = mesh.find_halfedge(Vertex(1), Vertex(0));
    CHECK(source(rim, BoundaryGraph(mesh)) == Vertex(1));
    CHECK(target(rim, BoundaryGraph(mesh)) == Vertex(0));
  }

  TEST_CASE("both halfedges of an edge have one value in every edge map of an undirected view") {
    for_each_specimen([](const Specimen&, const TestMesh& mesh, bool) {
      const PrimalGraph g(mesh);
      const auto number = edge_map([](Edge e) { return e.idx(); });
      for (const Halfedge h : edges_of(g)) {
        const Halfedge other = mesh.opposite_halfedge_handle(h);
        CHECK(get(boost::edge_index, g, h) == get(boost::edge_index, g, other));
        CHECK(get(number, h) == get(number, other));
        CHECK(get(number, h) == mesh.edge_handle(h).idx());
        CHECK(get(boost::edge_reverse, directed(g), h) == other);
        CHECK(get(boost::edge_index, directed(g), h) != get(boost::edge_index, directed(g), other));
      }
    });
  }

  TEST_CASE("the length map is the distance of the ends") {
    TestMesh mesh;
    add_triangles(mesh, 3, {{0, 1, 2}});
    mesh.set_point(Vertex(0), {0, 0, 0});
    mesh.set_point(Vertex(1), {3, 0, 0});
    mesh.set_point(Vertex(2), {3, 4, 0});
    const auto length = length_map(mesh);
    CHECK(get(length, mesh.find_halfedge(Vertex(0), Vertex(1))) == 3);
    CHECK(get(length, mesh.find_halfedge(Vertex(2), Vertex(1))) == 4);
    CHECK(get(length, mesh.find_halfedge(Vertex(0), Vertex(2))) == 5);
    CHECK(get(length, mesh.find_halfedge(Vertex(2), Vertex(0))) == 5);
  }

  TEST_CASE("the views of an empty mesh are empty") {
    TestMesh mesh;
    CHECK(num_vertices(PrimalGraph(mesh)) == 0);
    CHECK(num_edges(PrimalGraph(mesh)) == 0);
    add_triangles(mesh, 4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    CHECK(num_vertices(BoundaryGraph(mesh)) == 0);
    CHECK(num_edges(BoundaryGraph(mesh)) == 0);
    for (const Face f : {Face(0), Face(1), Face(2), Face(3)}) mesh.delete_face(f, true);
    CHECK(num_vertices(PrimalGraph(mesh)) == 0);
    CHECK(num_edges(directed(DualGraph(mesh))) == 0);
    const Vertex alone = mesh.new_vertex();
    CHECK(nodes_of(PrimalGraph(mesh)) == std::vector<Vertex>{alone});
    CHECK(out_degree(alone, PrimalGraph(mesh)) == 0);
    CHECK(nodes_of(BoundaryGraph(mesh)).empty());
  }
}
