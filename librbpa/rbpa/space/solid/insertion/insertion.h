// What:   builds the Delaunay triangulation of points in space, or the regular triangulation of balls, point by point.
//         docs/explanation/space.md, section 6, has a drawing.
// How:    three steps for each point:
//           1. walk from a recently made tetrahedron to one whose sphere contains the point;
//           2. find the cavity, all tetrahedra whose spheres contain the point, from neighbor to neighbor by levels;
//           3. join the faces of the cavity's boundary to the point.
//         The hull has a ghost tetrahedron over each face, so that points outside are no special case. A ball in no
//         sphere is hidden and makes no tetrahedron. A ball whose tetrahedra are all in a cavity becomes hidden.
// Law:    exact on any finite input. The tetrahedra do not depend on the order of the points.
// Cost:   a microsecond a point in spatial order; 90 bytes a tetrahedron.
// Source: Bowyer, Computing Dirichlet tessellations (1981); Watson (1981); ghosts: Shewchuk, Lecture notes on Delaunay
//         mesh generation (1999); stored minors: Marot, Pellerin, Remacle, One machine, one minute, three billion
//         tetrahedra (2019).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/sphere.h"
#include "rbpa/space/predicate/sphere_minors.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/solid/insertion/cavity_edges.h"
#include "rbpa/space/solid/insertion/stack.h"
#include "rbpa/space/solid/insertion/tetrahedra.h"

namespace rbpa::space {

/// An incremental triangulation of points or, if `weighted`, of balls.
template <bool weighted>
class BasicInsertion {
 public:
  /// Makes point order[i] vertex i + 1; begin() exchanges some vertices (see index()). Keeps the spans of points and
  /// radii: their arrays must outlive this object.
  /// Requires: `order` has indices of distinct, finite points, fewer than 2^32 − 1; `scaled` and `scaled_radii` are the
  ///           points and radii multiplied by the power of two of `spread` (spread.h); radii are given for balls only,
  ///           and `spread` is computed with the radii.
  BasicInsertion(std::span<const Point3> points, std::span<const Point3> scaled, const Spread& spread,
                 std::span<const std::uint32_t> order, std::span<const double> radii = {},
                 std::span<const double> scaled_radii = {});

  /// Inserts the first four points of the order that are not in a plane, as vertices 1 to 4. Returns false, and inserts
  /// nothing, if all points are in one plane.
  bool begin();
  /// Inserts vertex v. Returns the number of new tetrahedra, 0 for a hidden ball. Requires: begin() returned true;
  /// vertices are inserted in ascending order from 5 to size().
  std::size_t insert(Vertex v);

  Vertex size() const { return static_cast<Vertex>(vertex_.size() - 1); }
  /// Returns the input index of each vertex.
  std::span<const std::uint32_t> index() const { return index_; }
  /// Returns the point of a vertex for exact predicates: scaled where scaling is exact, else the given point.
  const Point3& point(Vertex v) const { return points_[index_[v]]; }

  std::span<const Tetrahedron> tetrahedra() const { return tetrahedra_; }
  bool is_deleted(std::uint32_t t) const { return error_[t].is_deleted(); }
  /// Returns whether the circumradius of a tetrahedron is at most alpha. Requires: the tetrahedron is no ghost; alpha
  /// is finite, and `scaled_alpha` is alpha times the power of two by which the points are scaled.
  bool is_within(std::uint32_t t, double alpha, double scaled_alpha) const requires(!weighted);

 private:
  using Inserted = std::conditional_t<weighted, InsertedBall, InsertedPoint>;
  using AnySpoke = std::conditional_t<weighted, WeightedSpoke, Spoke>;
  /// An estimate of V(q) in sphere_minors.h, and a bound of its error.
  struct Estimate {
    double value, error;
  };
  using Locals = std::array<std::uint32_t, 3>;  ///< numbers of three vertices of the cavity's boundary

  Estimate estimate(std::uint32_t t, const Inserted& q) const;
  bool is_inside(std::uint32_t t, Vertex v, const Estimate& estimate) const;
  bool decide(std::uint32_t t, Vertex v, const Estimate& estimate) const;
  bool decide_ghost(const Tetrahedron& ghost, Vertex v) const;
  std::uint32_t locate(Vertex v) const;
  std::uint32_t locate_exactly(std::uint32_t t, Vertex v) const;
  void find_cavity(std::uint32_t t, Vertex v);
  void fill_cavity(Vertex v);
  void make_room();
  void add_spoke(Vertex corner, const Inserted& from);
  std::uint32_t number_of(Vertex corner, Vertex v);
  void make(std::uint32_t t, const Locals& locals);
  std::uint32_t new_tetrahedra(std::size_t count);

  std::span<const Point3> original_, points_;
  std::span<const double> radii_;  // for exact predicates, scaled if points_ are
  Spread spread_;
  BeyondFilter beyond_filter_;
  std::vector<std::uint32_t> index_;  // for each vertex, its input index
  meshops::FreshVector<Inserted> vertex_;
  meshops::FreshVector<Tetrahedron> tetrahedra_;
  meshops::FreshVector<ErrorBound> error_;
  Stack<std::uint32_t> free_;  // deleted tetrahedra
  std::uint32_t start_ = 0;    // where the next walk starts

  // Data of the current insertion:
  Stack<std::uint32_t> cavity_;  // the tetrahedra of the cavity, then the new ones in place of them
  Stack<Face> boundary_;         // the faces of the cavity, numbered by the tetrahedra outside
  Stack<Face> level_, next_level_;
  Stack<Estimate> estimates_;
  Stack<Vertex> rim_;       // the vertices of the boundary
  Stack<AnySpoke> spokes_;  // from the new point to each vertex of rim_
  Stack<Locals> locals_;    // for each face of boundary_: the positions of its corners in rim_
  CavityEdges edges_;
};

using Insertion = BasicInsertion<false>;
using BallInsertion = BasicInsertion<true>;
extern template class BasicInsertion<false>;
extern template class BasicInsertion<true>;

}  // namespace rbpa::space
