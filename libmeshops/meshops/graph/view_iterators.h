// What: the iterators of the graph views: over all elements of a mesh, and once around a node.
// Cost: a step takes constant time, plus the number of elements that it skips. Nothing is allocated.
#pragma once

#include <boost/iterator/iterator_facade.hpp>
#include <cstddef>
#include <utility>

#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"

namespace meshops::detail {

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
    require(Kind::has(mesh, node), "graph view: vertex ", node.idx(), " is not in the graph");
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

}  // namespace meshops::detail
