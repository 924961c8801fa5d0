// What: a mesh viewed as a graph of Boost; the common base of the primal, dual and boundary graphs.
// Law:  an edge descriptor is a halfedge, which runs from source() to target(). In an undirected view, edges() lists
//       every edge by one of its two halfedges, and both have the same edge index. In a directed view, the two
//       halfedges of an edge are two edges, each with its own index and each the reverse of the other.
// Cost: a view is one pointer, passed by value. Iterators allocate nothing. A step takes constant time, plus the number
//       of elements that it skips.
#pragma once

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "meshops/graph/view_maps.h"

namespace meshops {
namespace detail {

inline int count_of(const Connectivity& mesh, Vertex) { return static_cast<int>(mesh.n_vertices()); }
inline int count_of(const Connectivity& mesh, Halfedge) { return static_cast<int>(mesh.n_halfedges()); }
inline int count_of(const Connectivity& mesh, Face) { return static_cast<int>(mesh.n_faces()); }

/// Iterator over the handles for which View::lists() is true, in ascending order.
template <typename View, typename Handle>
class ListIterator
    : public boost::iterator_facade<ListIterator<View, Handle>, Handle, boost::forward_traversal_tag, Handle> {
 public:
  ListIterator() = default;

  static std::pair<ListIterator, ListIterator> range(const Connectivity& mesh) {
    const int end = count_of(mesh, Handle());
    return {ListIterator(mesh, 0, end), ListIterator(mesh, end, end)};
  }

  /// Returns one more than the index of the last listed handle, or 0 if no handle is listed.
  static std::size_t index_bound(const Connectivity& mesh) {
    int bound = count_of(mesh, Handle());
    while (bound > 0 && !View::lists(mesh, Handle(bound - 1))) --bound;
    return static_cast<std::size_t>(bound);
  }

 private:
  friend boost::iterator_core_access;

  ListIterator(const Connectivity& mesh, int at, int end) : mesh_(&mesh), at_(at), end_(end) { pass_unlisted(); }

  Handle dereference() const { return Handle(at_); }
  bool equal(const ListIterator& other) const { return at_ == other.at_; }
  void increment() {
    ++at_;
    pass_unlisted();
  }
  void pass_unlisted() {
    while (at_ < end_ && !View::lists(*mesh_, Handle(at_))) ++at_;
  }

  const Connectivity* mesh_ = nullptr;
  int at_ = 0;
  int end_ = 0;
};

// Types whose function `of` computes the value of a TurnIterator from a halfedge that leaves the node.
struct LeavingEdge {
  using Value = Halfedge;
  static Halfedge of(const Connectivity&, Halfedge h) { return h; }
};
struct ArrivingEdge {
  using Value = Halfedge;
  static Halfedge of(const Connectivity& mesh, Halfedge h) { return mesh.opposite_halfedge_handle(h); }
};
template <typename Kind>
struct Neighbor {
  using Value = typename Kind::Node;
  static Value of(const Connectivity& mesh, Halfedge h) { return Kind::source(mesh, mesh.opposite_halfedge_handle(h)); }
};

/// Iterator once around a node, over the value Read::of() of each halfedge that leaves the node.
template <typename Kind, typename Read>
class TurnIterator : public boost::iterator_facade<TurnIterator<Kind, Read>, typename Read::Value,
                                                   boost::forward_traversal_tag, typename Read::Value> {
 public:
  TurnIterator() = default;

  static std::pair<TurnIterator, TurnIterator> range(const Connectivity& mesh, typename Kind::Node node) {
    constexpr bool is_of_faces = std::is_same_v<typename Kind::Node, Face>;
    require(Kind::has(mesh, node), is_of_faces ? "graph view: face " : "graph view: vertex ", node.idx(),
            " is not in the graph");
    const Halfedge first = Kind::first_leaving(mesh, node);
    return {TurnIterator(mesh, first, !first.is_valid()), TurnIterator(mesh, first, true)};
  }

 private:
  friend boost::iterator_core_access;

  TurnIterator(const Connectivity& mesh, Halfedge first, bool at_end)
      : mesh_(&mesh), first_(first), at_(first), at_end_(at_end) {}

  typename Read::Value dereference() const { return Read::of(*mesh_, at_); }
  bool equal(const TurnIterator& other) const { return at_ == other.at_ && at_end_ == other.at_end_; }
  void increment() {
    at_ = Kind::next_leaving(*mesh_, at_);
    at_end_ = at_ == first_;
  }

  const Connectivity* mesh_ = nullptr;
  Halfedge first_;
  Halfedge at_;
  bool at_end_ = true;
};

}  // namespace detail

/// View of a mesh as a graph, with a reference to the mesh. `Kind` defines which elements are nodes and edges, and how
/// edges turn around a node. `Direction` is boost::undirected_tag, or boost::bidirectional_tag for a graph in which
/// both halfedges of an edge are edges. Use the view as PrimalGraph, DualGraph or BoundaryGraph, and through
/// directed().
/// Requires:    the mesh is sound. Not checked.
/// Models:      BidirectionalGraph, AdjacencyGraph, VertexListGraph and EdgeListGraph, with parallel edges;
///              ReadablePropertyGraph for vertex_index and edge_index, and in a directed view also for edge_reverse.
/// Throws:      ContractViolation for the neighbors of a vertex that vertices() does not list, and for the ends of an
///              edge that is out of range.
/// Invalidated: by any change of the elements of the mesh. Elements marked deleted are skipped.
template <typename Kind, typename Direction>
class GraphView {
  static constexpr bool is_undirected = std::is_same_v<Direction, boost::undirected_tag>;
  struct Traversal : boost::bidirectional_graph_tag,
                     boost::adjacency_graph_tag,
                     boost::vertex_list_graph_tag,
                     boost::edge_list_graph_tag {};

 public:
  using vertex_descriptor = typename Kind::Node;
  using edge_descriptor = Halfedge;
  using directed_category = Direction;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  using traversal_category = Traversal;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;

  using vertex_iterator = detail::ListIterator<GraphView, vertex_descriptor>;
  using edge_iterator = detail::ListIterator<GraphView, Halfedge>;
  using out_edge_iterator = detail::TurnIterator<Kind, detail::LeavingEdge>;
  using in_edge_iterator = detail::TurnIterator<Kind, detail::ArrivingEdge>;
  using adjacency_iterator = detail::TurnIterator<Kind, detail::Neighbor<Kind>>;

  using VertexIndexMap = IndexMap<vertex_descriptor, 1>;
  using EdgeIndexMap = IndexMap<Halfedge, is_undirected ? 2 : 1>;

  explicit GraphView(const Connectivity& mesh) : mesh_(&mesh) {}
  explicit GraphView(const Connectivity&&) = delete;  // the view would outlive the mesh

  const Connectivity& mesh() const { return *mesh_; }
  static vertex_descriptor null_vertex() { return vertex_descriptor(); }

  /// Returns whether vertices() or edges() lists the element.
  static bool lists(const Connectivity& mesh, vertex_descriptor v) { return Kind::has(mesh, v); }
  static bool lists(const Connectivity& mesh, Halfedge h) {
    return Kind::has(mesh, h) && (!is_undirected || Kind::names_edge(mesh, h));
  }

  friend vertex_descriptor source(Halfedge h, const GraphView& g) { return Kind::source(*g.mesh_, g.in_range(h)); }
  friend vertex_descriptor target(Halfedge h, const GraphView& g) {
    return Kind::source(*g.mesh_, g.mesh_->opposite_halfedge_handle(g.in_range(h)));
  }

  friend auto vertices(const GraphView& g) { return vertex_iterator::range(*g.mesh_); }
  friend auto edges(const GraphView& g) { return edge_iterator::range(*g.mesh_); }
  friend auto out_edges(vertex_descriptor v, const GraphView& g) { return out_edge_iterator::range(*g.mesh_, v); }
  friend auto in_edges(vertex_descriptor v, const GraphView& g) { return in_edge_iterator::range(*g.mesh_, v); }
  friend auto adjacent_vertices(vertex_descriptor v, const GraphView& g) {
    return adjacency_iterator::range(*g.mesh_, v);
  }

  /// Returns one more than the greatest index of a listed vertex (num_edges(): of an edge), which is the size of an
  /// array by index; 0 if there is none. It is the number of vertices (edges) if the indices have no gaps: if nothing
  /// is marked deleted, and the view has all vertices (edges) of the mesh. Boost's algorithms allocate as many entries
  /// and address them by index, as for boost::filtered_graph.
  /// Cost: the length of the gap at the end of the indices.
  friend vertices_size_type num_vertices(const GraphView& g) { return vertex_iterator::index_bound(*g.mesh_); }
  friend edges_size_type num_edges(const GraphView& g) {
    const std::size_t halfedges = edge_iterator::index_bound(*g.mesh_);
    return is_undirected ? (halfedges + 1) / 2 : halfedges;
  }

  /// Returns the number of edges at a vertex: out_degree() counts edges that leave it, in_degree() edges that arrive;
  /// degree() counts both, but each edge of an undirected view once. Cost: the degree.
  friend degree_size_type out_degree(vertex_descriptor v, const GraphView& g) {
    const auto [first, last] = out_edges(v, g);
    return static_cast<degree_size_type>(std::distance(first, last));
  }
  friend degree_size_type in_degree(vertex_descriptor v, const GraphView& g) { return out_degree(v, g); }
  friend degree_size_type degree(vertex_descriptor v, const GraphView& g) {
    return (is_undirected ? 1 : 2) * out_degree(v, g);
  }

  friend VertexIndexMap get(boost::vertex_index_t, const GraphView&) { return {}; }
  friend EdgeIndexMap get(boost::edge_index_t, const GraphView&) { return {}; }
  friend ReverseMap get(boost::edge_reverse_t, const GraphView&) requires(!is_undirected) { return {}; }
  template <typename Property, typename Key>
  friend auto get(Property property, const GraphView& g, Key key) {
    return get(get(property, g), key);
  }

 private:
  Halfedge in_range(Halfedge h) const {
    require(h.idx() >= 0 && static_cast<std::size_t>(h.idx()) < mesh_->Connectivity::n_halfedges(),
            "graph view: halfedge ", h.idx(), " does not exist");
    return h;
  }

  const Connectivity* mesh_;
};

/// Returns the graph in which both halfedges of each edge are edges, as algorithms of maximum flow require.
template <typename Kind>
GraphView<Kind, boost::bidirectional_tag> directed(GraphView<Kind, boost::undirected_tag> view) {
  return GraphView<Kind, boost::bidirectional_tag>(view.mesh());
}

}  // namespace meshops
