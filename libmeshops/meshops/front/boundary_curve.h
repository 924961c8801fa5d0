// What: the boundary curves of a mesh as ranges of halfedges.
// Law:  every boundary halfedge is on exactly one curve. A curve is closed and has the mesh on its right.
#pragma once

#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Closed curve of the boundary halfedges through a given one, in the order of next(). The curve is a view: it refers
/// to the mesh and owns nothing. The curve and its iterators are valid until the boundary changes or garbage is
/// collected; an iterator may outlive its curve.
class MESHOPS_API BoundaryCurve {
 public:
  class Iterator {
   public:
    using iterator_concept = std::bidirectional_iterator_tag;
    using iterator_category = std::input_iterator_tag;  // `*it` is a value
    using value_type = Halfedge;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Halfedge;

    Iterator() = default;
    Iterator(const Connectivity& mesh, Halfedge at, bool at_end) : mesh_(&mesh), first_(at), at_(at), end_(at_end) {}
    Halfedge operator*() const { return at_; }
    Iterator& operator++() {
      at_ = mesh_->next_halfedge_handle(at_);
      end_ = at_ == first_;
      return *this;
    }
    Iterator operator++(int) {
      Iterator old = *this;
      ++*this;
      return old;
    }
    Iterator& operator--() {
      at_ = mesh_->prev_halfedge_handle(at_);
      end_ = false;
      return *this;
    }
    Iterator operator--(int) {
      Iterator old = *this;
      --*this;
      return old;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_ && a.end_ == b.end_; }

   private:
    const Connectivity* mesh_ = nullptr;
    Halfedge first_;
    Halfedge at_;
    bool end_ = true;
  };

  /// Views the curve through the halfedge `through`. The range begins with `through`.
  /// Requires: `through` is a live boundary halfedge; otherwise throws ContractViolation. The mesh is sound
  ///           (unchecked).
  BoundaryCurve(const Connectivity& mesh, Halfedge through);

  Iterator begin() const { return {*mesh_, through_, false}; }
  Iterator end() const { return {*mesh_, through_, true}; }
  Halfedge front() const { return through_; }
  /// Returns whether `h` is on this curve. Throws ContractViolation unless `h` is a live boundary halfedge.
  /// Cost: the shorter way along the curve to front(); if `h` is on another curve, the length of the shorter curve.
  bool contains(Halfedge h) const;

  /// Returns the number of edges. Cost: linear in that number.
  std::size_t length() const;

 private:
  const Connectivity* mesh_;
  Halfedge through_;
};

/// Returns the boundary curve through the vertex `v`, from the halfedge that leaves `v`; nothing if `v` is inner or
/// isolated.
/// Requires: `v` is live; throws ContractViolation otherwise. The mesh is sound; not checked.
/// Cost:     constant.
MESHOPS_API std::optional<BoundaryCurve> boundary_curve_at(const Connectivity& mesh, Vertex v);

/// Returns every boundary curve once, beginning with its least halfedge, in ascending order of the least halfedges.
/// Requires: the mesh is sound; not checked. Cost: linear in the number of halfedges.
MESHOPS_API std::vector<BoundaryCurve> boundary_curves(const Connectivity& mesh);

}  // namespace meshops
