// What:   the Delaunay triangulation of points in space, built point by point. docs/solid.md, section 4, has a drawing.
// How:    for each point
//           1. walk from a tetrahedron made last to one whose sphere has the point inside;
//           2. find all of them, the cavity, from neighbor to neighbor, level by level;
//           3. join the faces of its boundary to the point.
//         The hull has a ghost over each face, so that points outside are no special case.
// Law:    exact on any finite input. The tetrahedra do not depend on the order of the points.
// Cost:   a microsecond a point in spatial order; 90 bytes a tetrahedron.
// Source: Bowyer, Computing Dirichlet tessellations (1981); Watson (1981); ghosts: Shewchuk, Lecture notes on Delaunay mesh
//         generation (1999); minors kept: Marot, Pellerin, Remacle, One machine, one minute, three billion tetrahedra (2019).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/insertion/cavity_edges.h"
#include "rbpa/space/insertion/stack.h"
#include "rbpa/space/insertion/tetrahedra.h"
#include "rbpa/space/predicate/sphere.h"
#include "rbpa/space/predicate/sphere_minors.h"
#include "rbpa/space/predicate/spread.h"

namespace rbpa::space {

class Insertion {
 public:
  /// Keeps the spans. Requires: finite, distinct points, fewer than 2^32 − 1; the same points scaled (spread.h).
  Insertion(std::span<const Point3> points, std::span<const Point3> scaled, const Spread& spread,
            std::span<const std::uint32_t> order);

  /// The first four points of the order that are not in a plane: vertices 1 to 4. False where there are none, and nothing is made.
  bool begin();
  /// After that, every other vertex up to size(), ascending. Returns: how many tetrahedra it made.
  std::size_t insert(Vertex v);

  Vertex size() const { return static_cast<Vertex>(vertex_.size() - 1); }
  /// By vertices.
  std::span<const std::uint32_t> index() const { return index_; }
  /// For exact predicates.
  const Point3& point(Vertex v) const { return points_[index_[v]]; }

  std::span<const Tetrahedron> tetrahedra() const { return tetrahedra_; }
  bool is_deleted(std::uint32_t t) const { return error_[t].is_deleted(); }
  /// Whether the circumradius of a tetrahedron that is no ghost is at most alpha, which is finite.
  bool is_within(std::uint32_t t, double alpha, double scaled_alpha) const;

 private:
  /// V(q), and the bound of its error.
  struct Estimate {
    double value, error;
  };
  using Locals = std::array<std::uint32_t, 3>;  ///< numbers of vertices of the cavity's boundary

  Estimate estimate(std::uint32_t t, const InsertedPoint& q) const;
  bool is_inside(std::uint32_t t, Vertex v, const Estimate& estimate) const;
  bool decide(std::uint32_t t, Vertex v, const Estimate& estimate) const;
  bool decide_ghost(const Tetrahedron& ghost, Vertex v) const;
  std::uint32_t locate(Vertex v) const;
  std::uint32_t locate_exactly(std::uint32_t t, Vertex v) const;
  void find_cavity(std::uint32_t t, Vertex v);
  void fill_cavity(Vertex v);
  void make_room();
  void add_spoke(Vertex corner, const InsertedPoint& from);
  std::uint32_t number_of(Vertex corner, Vertex v);
  void make(std::uint32_t t, const Locals& locals);
  std::uint32_t new_tetrahedra(std::size_t count);

  std::span<const Point3> original_, points_;
  Spread spread_;
  BeyondFilter beyond_filter_;
  std::vector<std::uint32_t> index_;  // of each vertex
  meshops::FreshVector<InsertedPoint> vertex_;
  meshops::FreshVector<Tetrahedron> tetrahedra_;
  meshops::FreshVector<ErrorBound> error_;
  Stack<std::uint32_t> free_;  // deleted tetrahedra
  std::uint32_t start_ = 0;    // of the next walk

  // Of the point at hand.
  Stack<std::uint32_t> cavity_;  // its tetrahedra, and then those in their place
  Stack<Face> boundary_;         // its faces as those outside have them
  Stack<Face> level_, next_level_;
  Stack<Estimate> estimates_;
  Stack<Vertex> rim_;     // the vertices of the boundary
  Stack<Spoke> spokes_;   // of each of them, from the new point
  Stack<Locals> locals_;  // of each face of the boundary
  CavityEdges edges_;
};

}  // namespace rbpa::space
