#include "meshops/topology/homology.h"

#include <algorithm>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/core/live.h"
#include "meshops/graph/edge_map.h"
#include "meshops/graph/primal_graph.h"

namespace meshops {
namespace {

template <typename Handle>
std::size_t at(Handle handle) {
  return static_cast<std::size_t>(handle.idx());
}

/// Spanning forest of the vertices: for each vertex, its distance from its root, and the halfedge by which the forest
/// reaches it, which is invalid at a root.
struct Tree {
  std::vector<double> distance;
  std::vector<Halfedge> reached_by;

  bool has(const Connectivity& mesh, Edge e) const {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    return reached_by[at(mesh.to_vertex_handle(h))] == h ||
           reached_by[at(mesh.from_vertex_handle(h))] == mesh.opposite_halfedge_handle(h);
  }
};

/// Visitor of Boost that counts the edges that Boost examines.
struct Counting : boost::base_visitor<Counting> {
  using event_filter = boost::on_examine_edge;
  explicit Counting(Steps& steps) : step(&steps) {}
  template <typename E, typename Graph>
  void operator()(E, const Graph&) const {
    (*step)();
  }
  Steps* step;
};

/// Kind of the homology that is computed: absolute, or relative to the boundary. In relative homology, all boundary
/// points count as one, so that a path between two of them is a loop. The generators come from absolute homology, the
/// cut graph from relative homology; on a closed mesh both are the same.
enum class Modulo { nothing, boundary };

class TreeCotree {
 public:
  TreeCotree(const Connectivity& mesh, std::span<const double> lengths, Steps& step)
      : mesh_(mesh), lengths_(lengths), step_(step), component_(mesh.n_vertices()) {
    DisjointSets connected(mesh.n_vertices());
    const auto number = [](Vertex v) { return static_cast<std::uint32_t>(v.idx()); };
    for_each_edge(mesh, [&](Edge e) {
      step_();
      const Halfedge h = mesh.halfedge_handle(e, 0);
      connected.unite(number(mesh.from_vertex_handle(h)), number(mesh.to_vertex_handle(h)));
    });
    for_each_vertex(mesh, [&](Vertex v) {
      step_();
      component_[at(v)] = connected.find(number(v));
    });
  }

  std::vector<Loop> generators() const {
    std::vector<Loop> loops;
    const Tree tree = spanning_tree(roots(Modulo::nothing));
    for (const Edge e : left_over(tree, Modulo::nothing)) loops.push_back(loop(tree, mesh_.halfedge_handle(e, 0)));
    return loops;
  }

  std::vector<Edge> cut_graph() const {
    const Tree tree = spanning_tree(roots(Modulo::boundary));
    std::vector<Edge> cut = left_over(tree, Modulo::boundary);
    for_each_edge(mesh_, [&](Edge e) {
      step_();
      if (tree.has(mesh_, e)) cut.push_back(e);
    });
    std::sort(cut.begin(), cut.end());
    prune(cut);
    return cut;
  }

 private:
  /// Returns the vertices from which the tree grows. Modulo the boundary, these are all boundary vertices of a
  /// component that has some. Otherwise, it is the least vertex of a component.
  std::vector<Vertex> roots(Modulo modulo) const {
    std::vector<Vertex> found;
    std::vector<char> has_root(component_.size(), 0);  // for the least vertex of each component
    const auto add = [&](Vertex v) {
      found.push_back(v);
      has_root[component_[at(v)]] = 1;
    };
    if (modulo == Modulo::boundary)
      for_each_vertex(mesh_, [&](Vertex v) {
        if (mesh_.is_boundary(v)) add(v);
      });
    for_each_vertex(mesh_, [&](Vertex v) {
      if (!has_root[component_[at(v)]]) add(v);
    });
    return found;
  }

  Tree spanning_tree(const std::vector<Vertex>& roots) const {
    const PrimalGraph graph(mesh_);
    const auto index = get(boost::vertex_index, graph);
    Tree tree{std::vector<double>(num_vertices(graph), 0), std::vector<Halfedge>(num_vertices(graph))};
    const auto distance = boost::make_iterator_property_map(tree.distance.begin(), index);
    const auto reached_by = boost::make_iterator_property_map(tree.reached_by.begin(), index);
    if (lengths_.empty()) {
      boost::queue<Vertex> queue;
      boost::breadth_first_search(
          graph, roots.begin(), roots.end(), queue,
          boost::make_bfs_visitor(std::pair(
              Counting(step_), std::pair(boost::record_distances(distance, boost::on_tree_edge()),
                                         boost::record_edge_predecessors(reached_by, boost::on_tree_edge())))),
          boost::make_two_bit_color_map(num_vertices(graph), index));
    } else {
      boost::dijkstra_shortest_paths(
          graph, roots.begin(), roots.end(), boost::dummy_property_map(), distance, edge_map([this](Edge e) {
            step_();
            return lengths_[at(e)];
          }),
          index, std::less<>(), std::plus<>(), std::numeric_limits<double>::infinity(), 0.0,
          boost::make_dijkstra_visitor(boost::record_edge_predecessors(reached_by, boost::on_edge_relaxed())));
    }
    return tree;
  }

  /// Returns, ascending, the edges that are neither in the tree nor in the cotree. The cotree is a spanning forest of
  /// the faces across edges that are not in the tree; it prefers edges that close long loops with the tree. A boundary
  /// edge joins a face to the outside; modulo the boundary, boundary edges are left out.
  std::vector<Edge> left_over(const Tree& tree, Modulo modulo) const {
    struct Candidate {
      double loop;
      Edge edge;
    };
    std::vector<Candidate> candidates;
    for_each_edge(mesh_, [&](Edge e) {
      step_();
      if (tree.has(mesh_, e) || (modulo == Modulo::boundary && mesh_.is_boundary(e))) return;
      const Halfedge h = mesh_.halfedge_handle(e, 0);
      const double length = lengths_.empty() ? 1 : lengths_[at(e)];
      candidates.push_back(
          {tree.distance[at(mesh_.from_vertex_handle(h))] + tree.distance[at(mesh_.to_vertex_handle(h))] + length, e});
    });
    std::stable_sort(candidates.begin(), candidates.end(), [this](const Candidate& a, const Candidate& b) {
      step_();
      return a.loop > b.loop;
    });

    // One more entry stands for the outside. All components may share it, because no cycle through the outside runs
    // from one component to another.
    const std::size_t outside = mesh_.n_faces();
    DisjointSets joined(outside + 1);
    const auto side = [&](Edge e, unsigned which) {
      const Face f = mesh_.face_handle(mesh_.halfedge_handle(e, which));
      return static_cast<std::uint32_t>(f.is_valid() ? at(f) : outside);
    };
    std::vector<Edge> left;
    for (const Candidate& candidate : candidates) {
      step_();
      if (!joined.join(side(candidate.edge, 0), side(candidate.edge, 1))) left.push_back(candidate.edge);
    }
    std::sort(left.begin(), left.end());
    return left;
  }

  /// Returns the loop that consists of `closing` and the way along the tree from its end back to its start.
  Loop loop(const Tree& tree, Halfedge closing) const {
    // The paths from both ends to the root are found first; then their common part is removed.
    const auto to_root = [&](Vertex v) {
      std::vector<Halfedge> way;
      for (Halfedge h = tree.reached_by[at(v)]; h.is_valid(); h = tree.reached_by[at(mesh_.from_vertex_handle(h))])
        way.push_back(h);
      step_(1 + way.size());
      return way;
    };
    std::vector<Halfedge> up = to_root(mesh_.to_vertex_handle(closing));
    std::vector<Halfedge> down = to_root(mesh_.from_vertex_handle(closing));
    while (!up.empty() && !down.empty() && up.back() == down.back()) {
      up.pop_back();
      down.pop_back();
    }
    Loop loop = {closing};
    for (const Halfedge h : up) loop.push_back(mesh_.opposite_halfedge_handle(h));
    loop.insert(loop.end(), down.rbegin(), down.rend());
    return loop;
  }

  /// Repeatedly removes edges with an inner end at which no other edge of the cut ends, until no such edge is left.
  void prune(std::vector<Edge>& cut) const {
    std::vector<bool> is_in(mesh_.n_edges(), false);
    std::vector<int> degree(mesh_.n_vertices(), 0);
    std::vector<int> edges(mesh_.n_vertices(),
                           0);  // exclusive or of their indices at each vertex: of one edge, its index
    const auto toggle = [&](Edge e) {
      is_in[at(e)] = !is_in[at(e)];
      for (const unsigned end : {0u, 1u}) {
        const std::size_t v = at(mesh_.to_vertex_handle(mesh_.halfedge_handle(e, end)));
        degree[v] += is_in[at(e)] ? 1 : -1;
        edges[v] ^= e.idx();
      }
    };
    for (const Edge e : cut) toggle(e);
    for_each_vertex(mesh_, [&](Vertex v) {
      while (degree[at(v)] == 1 && !mesh_.is_boundary(v)) {
        const Edge last(edges[at(v)]);
        const Halfedge h = mesh_.halfedge_handle(last, 0);
        step_();
        v = mesh_.to_vertex_handle(h) == v ? mesh_.from_vertex_handle(h) : mesh_.to_vertex_handle(h);
        toggle(last);
      }
    });
    std::erase_if(cut, [&](Edge e) { return !is_in[at(e)]; });
  }

  const Connectivity& mesh_;
  std::span<const double> lengths_;
  Steps& step_;
  std::vector<std::uint32_t> component_;  // for each vertex, the least vertex of its component
};

Homology compute(const Connectivity& mesh, std::span<const double> lengths, const GoOn& go_on) {
  Steps step(go_on);
  const TreeCotree trees(mesh, lengths, step);
  return {trees.generators(), trees.cut_graph()};
}

void check(const Connectivity& mesh, std::span<const double> lengths) {
  require_one_each("homology", lengths.size(), "lengths", mesh.n_edges(), "edges");
  double sum = 0;
  for_each_edge(mesh, [&](Edge e) {
    if (!(lengths[at(e)] >= 0))
      throw ContractViolation((std::ostringstream() << "homology: found the length " << lengths[at(e)] << " of edge "
                                                    << e.idx() << ", expected 0 or more")
                                  .str());
    sum += lengths[at(e)];
  });
  require(std::isfinite(sum), "homology: found an infinite sum of lengths, expected a finite sum");
}

}  // namespace

Homology homology(const Connectivity& mesh, const GoOn& go_on) { return compute(mesh, {}, go_on); }

Homology homology(const Connectivity& mesh, std::span<const double> lengths, const GoOn& go_on) {
  check(mesh, lengths);
  return compute(mesh, lengths, go_on);
}

std::vector<Loop> homology_generators(const Connectivity& mesh, std::span<const double> lengths, const GoOn& go_on) {
  check(mesh, lengths);
  Steps step(go_on);
  return TreeCotree(mesh, lengths, step).generators();
}

}  // namespace meshops
