// Runs Boost's algorithms on the views, with the storage that they allocate by default, and compares with answers found
// without them.
#include <doctest/doctest.h>

#include <algorithm>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/edmonds_karp_max_flow.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/graph/undirected_dfs.hpp>
#include <limits>
#include <numeric>

#include "graph/support.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/graph/boundary_graph.h"
#include "meshops/graph/dual_graph.h"
#include "meshops/graph/edge_map.h"
#include "meshops/graph/primal_graph.h"
#include "meshops/topology/count.h"

using namespace meshops;
using namespace meshops::test;

namespace {

template <typename Graph>
std::size_t component_count(const Graph& g) {
  std::vector<std::size_t> component(num_vertices(g));
  return boost::connected_components(g,
                                     boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, g)));
}

/// Returns a small integer for every edge, different from edge to edge.
auto some_numbers(unsigned seed, std::size_t edges) {
  std::mt19937 random(seed);
  std::vector<int> number(edges);
  for (int& n : number) n = static_cast<int>(random() % 9 + 1);
  return edge_map([number](Edge e) { return number[index(e)]; });
}

constexpr int unreached = std::numeric_limits<int>::max();

/// Returns distances by relaxing all edges until nothing changes (Bellman, Ford).
template <typename Graph, typename Weight>
std::vector<int> relaxed_distances(const Graph& g, typename Graph::vertex_descriptor start, Weight weight) {
  std::vector<int> distance(num_vertices(g), unreached);
  distance[index(start)] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Halfedge h : edges_of(g)) {
      int &a = distance[index(source(h, g))], &b = distance[index(target(h, g))];
      const int step = get(weight, h);
      if (a != unreached && a + step < b) b = a + step, changed = true;
      if (b != unreached && b + step < a) a = b + step, changed = true;
    }
  }
  return distance;
}

template <typename Graph>
void check_distances(const Graph& g, std::size_t mesh_edges) {
  const auto nodes = nodes_of(g);
  if (nodes.empty()) return;
  const auto start = nodes[nodes.size() / 2];
  const auto by_index = [&](std::vector<int>& v) {
    return boost::make_iterator_property_map(v.begin(), get(boost::vertex_index, g));
  };
  std::vector<int> hops(num_vertices(g), unreached);
  hops[index(start)] = 0;
  boost::breadth_first_search(
      g, start,
      boost::visitor(boost::make_bfs_visitor(boost::record_distances(by_index(hops), boost::on_tree_edge()))));
  const std::vector<int> expected_hops = relaxed_distances(g, start, edge_map([](Edge) { return 1; }));
  const auto weight = some_numbers(3, mesh_edges);
  std::vector<int> distance(num_vertices(g));
  boost::dijkstra_shortest_paths(g, start, boost::weight_map(weight).distance_map(by_index(distance)));
  const std::vector<int> expected = relaxed_distances(g, start, weight);
  for (const auto v : nodes) {
    CHECK(hops[index(v)] == expected_hops[index(v)]);
    CHECK(distance[index(v)] == expected[index(v)]);
  }
}

/// Runs Kruskal's algorithm as published: returns the weight of a lightest forest, and its number of edges.
template <typename Graph, typename Weight>
std::pair<long, std::size_t> lightest_forest(const Graph& g, Weight weight) {
  std::vector<std::size_t> label(num_vertices(g));
  std::iota(label.begin(), label.end(), std::size_t{0});
  std::vector<Halfedge> order = edges_of(g);
  std::stable_sort(order.begin(), order.end(), [&](Halfedge a, Halfedge b) { return get(weight, a) < get(weight, b); });
  std::pair<long, std::size_t> forest{0, 0};
  for (const Halfedge h : order) {
    const std::size_t a = label[index(source(h, g))], b = label[index(target(h, g))];
    if (a == b) continue;
    std::replace(label.begin(), label.end(), b, a);
    forest.first += get(weight, h);
    ++forest.second;
  }
  return forest;
}

template <typename Graph>
void check_spanning_forest(const Graph& g, std::size_t mesh_edges) {
  const auto weight = some_numbers(4, mesh_edges);
  std::vector<Halfedge> forest;
  boost::kruskal_minimum_spanning_tree(g, std::back_inserter(forest), boost::weight_map(weight));
  long total = 0;
  for (const Halfedge h : forest) total += get(weight, h);
  CHECK(forest.size() == nodes_of(g).size() - component_count(g));
  CHECK(std::pair(total, forest.size()) == lightest_forest(g, weight));
}

/// Returns the least capacity of a set of edges between the nodes on the start's side and the others, over all sets of
/// nodes.
template <typename Graph, typename Capacity>
int least_cut(const Graph& g, typename Graph::vertex_descriptor from, typename Graph::vertex_descriptor to,
              Capacity capacity) {
  const auto nodes = nodes_of(g);
  REQUIRE(nodes.size() <= 16);
  std::vector<unsigned> bit(num_vertices(g), 0);
  for (unsigned i = 0; i < nodes.size(); ++i) bit[index(nodes[i])] = 1u << i;
  int best = unreached;
  for (unsigned side = 0; side < 1u << nodes.size(); ++side) {
    if (!(side & bit[index(from)]) || (side & bit[index(to)])) continue;
    int cut = 0;
    for (const Halfedge h : edges_of(g))
      if (!(side & bit[index(source(h, g))]) != !(side & bit[index(target(h, g))])) cut += get(capacity, h);
    best = std::min(best, cut);
  }
  return best;
}

template <typename Graph>
void check_flow(const Graph& undirected, unsigned seed, std::size_t mesh_edges) {
  auto g = directed(undirected);
  const auto nodes = nodes_of(g);
  const auto from = nodes.front(), to = nodes.back();
  const auto capacity = some_numbers(seed, mesh_edges);
  std::vector<int> residual(num_edges(g));
  const auto residual_map = boost::make_iterator_property_map(residual.begin(), get(boost::edge_index, g));
  const int cut = least_cut(undirected, from, to, capacity);
  CHECK(boost::boykov_kolmogorov_max_flow(g, capacity, residual_map, get(boost::edge_reverse, g),
                                          get(boost::vertex_index, g), from, to) == cut);
  CHECK(boost::edmonds_karp_max_flow(g, from, to, boost::capacity_map(capacity).residual_capacity_map(residual_map)) ==
        cut);
  std::vector<int> out(num_vertices(g));  // for each vertex, outflow minus inflow
  for (const Halfedge h : edges_of(g)) {
    CHECK(get(residual_map, h) >= 0);
    CHECK(get(residual_map, h) + get(residual_map, get(boost::edge_reverse, g, h)) == 2 * get(capacity, h));
    out[index(source(h, g))] += get(capacity, h) - get(residual_map, h);
  }
  for (const auto v : nodes) CHECK(out[index(v)] == (v == from ? cut : v == to ? -cut : 0));
}

struct IsInner {
  bool operator()(Halfedge h) const { return !mesh->is_boundary(mesh->edge_handle(h)); }
  const Connectivity* mesh = nullptr;
};

struct BackEdges : boost::default_dfs_visitor {
  explicit BackEdges(std::size_t& counter) : number(&counter) {}
  template <typename Graph>
  void back_edge(Halfedge, const Graph&) {
    ++*number;
  }
  std::size_t* number;
};

/// Checks that every edge is in the forest of the search or goes back, once.
template <typename Graph>
void check_depth_first(const Graph& g) {
  if (nodes_of(g).empty()) return;
  std::vector<boost::default_color_type> color(num_edges(g));
  std::size_t back = 0;
  boost::undirected_dfs(
      g, boost::visitor(BackEdges(back))
             .edge_color_map(boost::make_iterator_property_map(color.begin(), get(boost::edge_index, g))));
  CHECK(back == edges_of(g).size() - (nodes_of(g).size() - component_count(g)));
}

}  // namespace

TEST_SUITE("algorithms on graph views") {
  TEST_CASE("components are those of the mesh, its faces, its boundary curves") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      CAPTURE(specimen.name);
      const TopologyCounts counts = count_topology(mesh);
      CHECK(component_count(PrimalGraph(mesh)) == counts.components);
      CHECK(component_count(DualGraph(mesh)) == counts.components - counts.isolated);
      CHECK(component_count(BoundaryGraph(mesh)) == counts.boundary_curves);
    });
  }

  TEST_CASE("a component of the boundary graph is one boundary curve") {
    for_each_specimen([](const Specimen&, const TestMesh& mesh, bool) {
      const BoundaryGraph g(mesh);
      std::vector<std::size_t> component(num_vertices(g));
      boost::connected_components(g, boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, g)));
      for (const BoundaryCurve& curve : boundary_curves(mesh))
        for (const Halfedge h : curve)
          CHECK(component[index(source(h, g))] == component[index(mesh.from_vertex_handle(curve.front()))]);
    });
  }

  TEST_CASE("breadth-first and Dijkstra's distances are those of repeated relaxation") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      CAPTURE(specimen.name);
      check_distances(PrimalGraph(mesh), mesh.n_edges());
      check_distances(DualGraph(mesh), mesh.n_edges());
      check_distances(BoundaryGraph(mesh), mesh.n_edges());
    });
  }

  TEST_CASE("Kruskal's forest spans every component and has the least weight") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      CAPTURE(specimen.name);
      check_spanning_forest(PrimalGraph(mesh), mesh.n_edges());
      check_spanning_forest(DualGraph(mesh), mesh.n_edges());
      check_spanning_forest(BoundaryGraph(mesh), mesh.n_edges());
    });
  }

  TEST_CASE("an undirected search sees every edge once") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      CAPTURE(specimen.name);
      check_depth_first(PrimalGraph(mesh));
      check_depth_first(DualGraph(mesh));
      check_depth_first(BoundaryGraph(mesh));
    });
  }

  TEST_CASE("maximum flow is minimum cut") {
    for (unsigned seed = 0; seed < 20; ++seed) {
      TestMesh mesh;
      strip(mesh, 5);
      check_flow(PrimalGraph(mesh), seed, mesh.n_edges());
      check_flow(DualGraph(mesh), seed, mesh.n_edges());
      check_flow(BoundaryGraph(mesh), seed, mesh.n_edges());
    }
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      CAPTURE(specimen.name);
      if (specimen.components != 1) return;
      if (nodes_of(PrimalGraph(mesh)).size() <= 12) check_flow(PrimalGraph(mesh), 1, mesh.n_edges());
      if (const auto n = nodes_of(DualGraph(mesh)).size(); n >= 2 && n <= 12)
        check_flow(DualGraph(mesh), 1, mesh.n_edges());
    });
  }

  TEST_CASE("a mesh of genus 0 is a planar graph, its dual is another, and more than 3V - 6 edges are not planar") {
    int planar = 0, not_planar = 0;
    for_each_specimen([&](const Specimen& specimen, const TestMesh& mesh, bool with_gaps) {
      if (with_gaps) return;  // Boost numbers the vertices anew here, without gaps
      CAPTURE(specimen.name);
      const PrimalGraph g(mesh);
      if (count_topology(mesh).genus() == 0) {
        CHECK(boost::boyer_myrvold_planarity_test(g));
        CHECK(boost::boyer_myrvold_planarity_test(DualGraph(mesh)));
        ++planar;
      } else if (specimen.simplicial && edges_of(g).size() + 6 > 3 * nodes_of(g).size()) {
        CHECK_FALSE(boost::boyer_myrvold_planarity_test(g));
        ++not_planar;
      }
    });
    CHECK(planar > 0);
    CHECK(not_planar > 0);
  }

  TEST_CASE("in a filtered view without boundary edges, boundary vertices of one face are isolated") {
    TestMesh mesh;
    add_triangles(mesh, 4, {{0, 1, 2}, {0, 2, 3}});
    const PrimalGraph g(mesh);
    const auto inner = boost::make_filtered_graph(g, IsInner{&mesh});
    CHECK(component_count(inner) == 3);
  }
}
