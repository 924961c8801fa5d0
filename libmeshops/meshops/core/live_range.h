// What: the live elements of a mesh as ranges, for loops such as for (const Face f : live_faces(mesh)).
// Law:  a range has the elements that for_each_vertex(), for_each_halfedge(), for_each_edge() or for_each_face()
//       (core/live.h) visits, in the same order. A loop may mark elements deleted, including the current element. A
//       loop may add elements, which are not visited. A loop must not collect garbage.
// Cost: constant for each element, including elements marked deleted.
#pragma once

#include <cstddef>
#include <iterator>

#include "meshops/core/connectivity.h"
#include "meshops/core/live.h"

namespace meshops {

/// Range of the live elements of one kind, as handles of the type `Element`.
template <typename Element>
class LiveRange {
 public:
  /// Forward iterator. A default-constructed iterator belongs to no range.
  class Iterator {
   public:
    using value_type = Element;
    using difference_type = std::ptrdiff_t;
    using reference = Element;
    using pointer = void;
    using iterator_category = std::input_iterator_tag;
    using iterator_concept = std::forward_iterator_tag;

    Iterator() = default;
    /// Begins at the first live element whose number is at least `at` and below `end`; at `end` if there is none.
    Iterator(const Connectivity& mesh, int at, int end) : mesh_(&mesh), at_(at), end_(end) { skip_deleted(); }
    Element operator*() const { return Element(at_); }
    Iterator& operator++() {
      ++at_;
      skip_deleted();
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    void skip_deleted() {
      while (at_ < end_ && !is_live(*mesh_, Element(at_))) ++at_;
    }
    const Connectivity* mesh_ = nullptr;
    int at_ = 0, end_ = 0;
  };

  /// Makes the range of the live elements with numbers below `count`. Keeps a reference to the mesh.
  LiveRange(const Connectivity& mesh, std::size_t count) : mesh_(&mesh), count_(static_cast<int>(count)) {}
  Iterator begin() const { return {*mesh_, 0, count_}; }
  Iterator end() const { return {*mesh_, count_, count_}; }
  bool empty() const { return begin() == end(); }

 private:
  const Connectivity* mesh_;
  int count_;
};

/// Returns the live elements of one kind, in ascending order of handles. The range keeps a reference to the mesh, and
/// has no element that is added after this call.
inline LiveRange<Vertex> live_vertices(const Connectivity& mesh) { return {mesh, mesh.n_vertices()}; }
inline LiveRange<Halfedge> live_halfedges(const Connectivity& mesh) { return {mesh, mesh.n_halfedges()}; }
inline LiveRange<Edge> live_edges(const Connectivity& mesh) { return {mesh, mesh.n_edges()}; }
inline LiveRange<Face> live_faces(const Connectivity& mesh) { return {mesh, mesh.n_faces()}; }
// The range would outlive the mesh.
LiveRange<Vertex> live_vertices(const Connectivity&&) = delete;
LiveRange<Halfedge> live_halfedges(const Connectivity&&) = delete;
LiveRange<Edge> live_edges(const Connectivity&&) = delete;
LiveRange<Face> live_faces(const Connectivity&&) = delete;

}  // namespace meshops
