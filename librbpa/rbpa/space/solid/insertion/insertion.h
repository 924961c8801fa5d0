// What:   builds the Delaunay triangulation of points in space, or the regular triangulation of balls, by inserting one
//         vertex after the other, in one thread or several. docs/explanation/space.md, section 6, has a drawing.
// How:    rounds, each over seven times as many vertices as all rounds before. The curve along which the vertices are
//         sorted is divided into pieces, and each piece belongs to one worker (inserter.h). Vertices whose cavities
//         belong to several workers wait for further passes, with half as many pieces each, moved by half a piece along
//         the curve. One worker inserts the few vertices that wait after the passes with two pieces.
// Law:    exact on any finite input. The tetrahedra depend neither on the order of the points nor on the workers.
// Cost:   a few microseconds a point (docs/explanation/space.md, section 16).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/insertion/inserter.h"
#include "rbpa/space/solid/insertion/spatial_order.h"
#include "rbpa/space/solid/insertion/tetrahedra.h"

namespace rbpa::space {

/// The division of an insertion among workers.
struct Division {
  std::size_t workers = 0;       ///< at most 255; 0: as many as threads
  std::size_t least = 1u << 13;  ///< least number of vertices in each piece before a round, at least 2
};

/// An incremental triangulation of points or, if `weighted`, of balls.
template <bool weighted>
class BasicInsertion {
 public:
  /// Makes point order.order[i] vertex i + 1; insert_all() exchanges some vertices (see index()). Keeps the spans of
  /// points and radii, and a reference to the threads: all must outlive this object.
  /// Requires: `order` has distinct, finite points, fewer than 2^32 − 1, and their places, or no places if there is one
  ///           worker; `scaled` and `scaled_radii` are the points and radii multiplied by the power of two of `spread`
  ///           (spread.h); radii are given for balls only, and `spread` is computed with the radii.
  BasicInsertion(std::span<const Point3> points, std::span<const Point3> scaled, const Spread& spread,
                 const SpatialOrder& order, Threads& threads, std::span<const double> radii = {},
                 std::span<const double> scaled_radii = {}, Division division = {});

  /// Inserts all vertices. Returns false, and inserts none, if all points are in one plane. Throws Cancelled.
  bool insert_all(const OnProgress& progress);

  Vertex size() const { return all_.size(); }
  /// Returns the input index of each vertex.
  std::span<const std::uint32_t> index() const { return all_.index(); }
  std::span<const Tetrahedron> tetrahedra() const { return all_.tetrahedra(); }
  bool is_deleted(std::uint32_t t) const { return all_.is_deleted(t); }
  /// Returns what BasicTetrahedra::is_within() returns.
  bool is_within(std::uint32_t t, double alpha, double scaled_alpha) const requires(!weighted) {
    return all_.is_within(t, alpha, scaled_alpha);
  }
  /// Frees all but the tetrahedra and the input indices: only index() and tetrahedra() can be called later.
  void keep_rows() {
    all_.keep_rows();
    workers_.clear();
    for (auto* const of : {&place_, &hint_}) std::vector<std::uint32_t>().swap(*of);
    std::vector<std::uint8_t>().swap(owner_);
  }
  /// Returns the number of vertices that waited after the first pass of a round, and after the last one.
  std::array<std::size_t, 2> waited() const { return waited_; }

 private:
  struct alignas(128) Worker {  // two cache lines: no worker writes to one that another reads
    BasicInserter<weighted> inserter;
    std::vector<Vertex> vertices;  ///< to be inserted, then those that wait
    bool has_begun = false;        ///< whether the worker has inserted a vertex in this pass
  };
  class Counter;

  bool begin();
  void insert_shared(std::vector<Vertex>& vertices, std::size_t pieces, bool is_moved, Counter& counter);
  void insert_part(std::size_t number, Counter& counter);
  void insert_alone(Vertex v);
  std::size_t owner_of_place(std::size_t place) const { return (place + moved_by_) / piece_ % pieces_; }
  std::uint32_t hint_near(std::size_t place, std::size_t number) const;

  Threads& threads_;
  Division division_;
  BasicTetrahedra<weighted> all_;
  std::vector<Worker> workers_;
  std::array<std::size_t, 2> waited_{};

  // Used by several workers only:
  std::vector<std::uint32_t> place_;  // for each vertex, its place on the curve
  std::vector<std::uint32_t> hint_;   // for each few places of the curve, a tetrahedron that was made there
  std::vector<std::uint8_t> owner_;   // for each vertex, its worker
  std::size_t pieces_ = 1, piece_ = 1, moved_by_ = 0;  // number of pieces, places in each
};

using Insertion = BasicInsertion<false>;
using BallInsertion = BasicInsertion<true>;
extern template class BasicInsertion<false>;
extern template class BasicInsertion<true>;

}  // namespace rbpa::space
