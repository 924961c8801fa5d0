// What: stores the vertices and tetrahedra of a triangulation in arrays, each tetrahedron with the minors of its
//       circumsphere (space/predicate/sphere_minors.h), and tests whether a vertex is inside of such a sphere.
// How:  a corner may be at infinity: the tetrahedron is then a ghost over a face of the hull, and its sphere is the
//       half-space beyond the face. Corner 3 is never at infinity; the minors are relative to corner 3.
//
//         minor 32 | corner 16 | neighbor 16      a cache line
//         error 8                                 an array of its own
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/sphere.h"
#include "rbpa/space/predicate/sphere_minors.h"
#include "rbpa/space/predicate/spread.h"

namespace rbpa::space {

/// The number of a vertex: 0 for the vertex at infinity; points are numbered from 1 in the order of insertion.
using Vertex = std::uint32_t;
inline constexpr Vertex at_infinity = 0;

/// The number of a face: 4 · (number of the tetrahedron) + (corner of the tetrahedron across from the face).
using Face = std::uint32_t;

struct alignas(64) Tetrahedron {
  SphereMinors minor;
  std::array<Vertex, 4> corner;
  std::array<Face, 4> neighbor;  ///< the face across from each corner, as a face of the neighbor

  bool is_ghost() const {  // corner 3 is never at infinity
    return corner[0] == at_infinity || corner[1] == at_infinity || corner[2] == at_infinity;
  }
};

/// A point in the form that the insertion uses.
struct alignas(32) InsertedPoint : Point3 {
  std::uint32_t last_insertion = 0;  ///< the last vertex whose cavity has this point on its boundary
  std::uint32_t local = 0;           ///< number of this point on the boundary of that cavity
};

/// A ball in the form that the insertion uses.
struct InsertedBall : InsertedPoint {
  double radius = 0;
};

/// The vertices and tetrahedra of points or, if `weighted`, of balls. BasicInserter makes and deletes tetrahedra.
template <bool weighted>
class BasicTetrahedra {
 public:
  using VertexData = std::conditional_t<weighted, InsertedBall, InsertedPoint>;
  /// An estimate of V(q) in sphere_minors.h, and a bound of its error.
  struct Estimate {
    double value, error;
  };

  /// Makes point order[i] vertex i + 1. Keeps the spans of points and radii. Has room for `room` tetrahedra.
  /// Requires: what BasicInsertion requires (insertion.h).
  BasicTetrahedra(std::span<const Point3> points, std::span<const Point3> scaled, const Spread& spread,
                  std::span<const std::uint32_t> order, std::span<const double> radii,
                  std::span<const double> scaled_radii, std::size_t room, Threads& threads);

  Vertex size() const { return static_cast<Vertex>(vertex_.size() - 1); }
  void exchange(Vertex v, Vertex w);
  /// Returns the input index of each vertex.
  std::span<const std::uint32_t> index() const { return index_; }
  /// Returns the point of a vertex for exact predicates: scaled where scaling is exact, else the given point.
  const Point3& point(Vertex v) const {
    if (spread_.is_exact) return vertex_[v];  // near other vertices of the neighborhood in memory
    return points_[index_[v]];
  }
  double underflow() const { return spread_.underflow(); }

  /// Returns the number of tetrahedra, deleted ones included.
  std::uint32_t used() const { return used_; }
  bool is_deleted(std::uint32_t t) const { return error_[t].is_deleted(); }
  const Tetrahedron& operator[](std::uint32_t t) const { return tetrahedra_[t]; }
  std::span<const Tetrahedron> tetrahedra() const { return {tetrahedra_.data(), used_}; }

  /// Adds `count` deleted tetrahedra, and returns the first. The arrays may move.
  /// Throws: InvalidInput for more than 2^30 tetrahedra.
  std::uint32_t add(std::uint32_t count);
  /// Has room for at least `room` tetrahedra, or for 2^30. The arrays may move.
  void make_room(std::size_t room);
  /// Adds `count` deleted tetrahedra where there is room, in any thread: returns false if there is none.
  bool add_in_room(std::uint32_t count, std::uint32_t& first);

  /// Frees all but the tetrahedra and the input indices. Requires: none of the other data is used later.
  void keep_rows() {
    meshops::FreshVector<VertexData>().swap(vertex_);
    meshops::FreshVector<ErrorBound>().swap(error_);
  }

  VertexData* vertices() { return vertex_.data(); }
  Tetrahedron* all() { return tetrahedra_.data(); }
  ErrorBound* errors() { return error_.data(); }

  Estimate estimate(std::uint32_t t, const VertexData& q) const {
    const Tetrahedron& tetrahedron = tetrahedra_[t];
    const VertexData& d = vertex_[tetrahedron.corner[3]];
    const double x = q.x - d.x, y = q.y - d.y, z = q.z - d.z, square = x * x + y * y + z * z;
    const auto& m = tetrahedron.minor;
    if constexpr (weighted) {
      const double weight = weight_difference(q.radius, d.radius);
      return {m[0] * x + m[1] * y + m[2] * z + m[3] * (square - weight), error_[t].at(square + std::abs(weight))};
    }
    return {m[0] * x + m[1] * y + m[2] * z + m[3] * square, error_[t].at(square)};
  }
  /// Returns whether vertex v is inside of the sphere of t. `estimate` is estimate(t, v).
  bool is_inside(std::uint32_t t, Vertex v, const Estimate& estimate) const {
    if (estimate.value > estimate.error) return true;
    if (estimate.value < -estimate.error) return false;
    return decide(t, v, estimate);
  }
  /// Returns what is_inside() returns, by exact arithmetic.
  bool decide(std::uint32_t t, Vertex v, const Estimate& estimate) const;
  /// Returns whether the circumradius of a tetrahedron is at most alpha. Requires: points, no balls; the tetrahedron is
  /// no ghost; alpha is finite, and `scaled_alpha` is alpha times the power of two by which the points are scaled.
  bool is_within(std::uint32_t t, double alpha, double scaled_alpha) const;

 private:
  bool decide_ghost(const Tetrahedron& ghost, Vertex v, const Estimate& estimated) const;

  std::span<const Point3> points_;
  std::span<const double> radii_;  // for exact predicates, scaled where scaling is exact
  Spread spread_;
  BeyondFilter beyond_filter_;
  std::vector<std::uint32_t> index_;  // for each vertex, its input index
  meshops::FreshVector<VertexData> vertex_;
  meshops::FreshVector<Tetrahedron> tetrahedra_;
  meshops::FreshVector<ErrorBound> error_;
  std::atomic<std::uint32_t> used_ = 0;
};

extern template class BasicTetrahedra<false>;
extern template class BasicTetrahedra<true>;

}  // namespace rbpa::space
