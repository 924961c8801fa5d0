// What:   inserts vertices into a triangulation of points in space, or of balls, one by one: the work of one thread.
// How:    three steps for each vertex:
//           1. walk from a tetrahedron nearby to one whose sphere contains the vertex;
//           2. find the cavity, all tetrahedra whose spheres contain the vertex, from neighbor to neighbor by levels;
//           3. join the faces of the cavity's boundary to the vertex.
//         The hull has a ghost tetrahedron over each face, so that points outside are no special case. A ball in no
//         sphere is hidden and makes no tetrahedron. A ball whose tetrahedra are all in a cavity becomes hidden.
// Law:    several threads work on one triangulation without locks if each vertex has one owner: an inserter deletes a
//         tetrahedron, and follows or changes a link across a face, only if it owns all corners. Every word that an
//         inserter reads is then written by no other one (docs/explanation/space.md, section 7). An insertion that
//         would need more is refused, and changes nothing.
// Cost:   a microsecond a point in spatial order; 72 bytes a tetrahedron.
// Source: Bowyer, Computing Dirichlet tessellations (1981); Watson (1981); ghosts: Shewchuk, Lecture notes on Delaunay
//         mesh generation (1999); stored minors: Marot, Pellerin, Remacle, One machine, one minute, three billion
//         tetrahedra (2019).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "rbpa/space/predicate/sphere_minors.h"
#include "rbpa/space/solid/insertion/cavity_edges.h"
#include "rbpa/space/solid/insertion/stack.h"
#include "rbpa/space/solid/insertion/tetrahedra.h"

namespace rbpa::space {

enum class InsertionResult { yes, not_reached, not_owned };

template <bool weighted>
class BasicInserter {
 public:
  /// Keeps a reference to the tetrahedra.
  explicit BasicInserter(BasicTetrahedra<weighted>& all) : all_(all) {}

  /// Makes this inserter the one with the number `me`. `owner` has the inserter that owns each vertex; the vertex at
  /// infinity belongs to all. A null pointer makes this inserter the only one: it owns all vertices.
  void own(const std::uint8_t* owner, std::uint8_t me) {
    owner_ = owner;
    me_ = me;
  }
  /// Returns whether this inserter owns all corners of a tetrahedron.
  bool owns(std::uint32_t t) const;

  /// Makes the first tetrahedron, of vertices 1 to 4, and its ghosts. Requires: no tetrahedra yet; positively oriented
  /// vertices.
  void begin();
  /// Inserts vertex v, after a walk from tetrahedron t. Changes nothing unless the result is `yes`: with `not_reached`,
  /// a walk from another tetrahedron may end better; with `not_owned`, the cavity has a tetrahedron of other owners, or
  /// there is no room for tetrahedra.
  /// Requires: t is not deleted; this inserter owns t and v.
  InsertionResult insert(Vertex v, std::uint32_t t);

  /// Returns a tetrahedron at the vertex inserted last, or one that contains its center if it is a hidden ball.
  std::uint32_t last() const { return last_; }
  /// Returns the number of tetrahedra made by the last insertion.
  std::size_t made() const { return boundary_.size(); }

 private:
  using VertexData = typename BasicTetrahedra<weighted>::VertexData;
  using Estimate = typename BasicTetrahedra<weighted>::Estimate;
  using AnySpoke = std::conditional_t<weighted, WeightedSpoke, Spoke>;
  using Locals = std::array<std::uint32_t, 3>;  ///< numbers of three vertices of the cavity's boundary
  static constexpr std::uint32_t none = 0xffffffff;

  bool owns_corner(Vertex corner) const { return owner_[corner] == me_ || corner == at_infinity; }
  bool owns_beyond(Face face) const;
  std::uint32_t locate(Vertex v, std::uint32_t t, InsertionResult& refusal) const;
  std::uint32_t locate_exactly(std::uint32_t t, Vertex v, InsertionResult& refusal) const;
  bool find_cavity(std::uint32_t first, Vertex v);
  void give_up_cavity();
  bool make_room();
  void fill_cavity(Vertex v);
  void add_spoke(Vertex corner, const VertexData& from);
  std::uint32_t number_of(Vertex corner, Vertex v);
  void make(std::uint32_t t, const Locals& locals);

  BasicTetrahedra<weighted>& all_;
  const std::uint8_t* owner_ = nullptr;
  std::uint8_t me_ = 0;
  std::uint32_t last_ = none;
  Stack<std::uint32_t> free_;  // deleted tetrahedra, which this inserter may use
  VertexData infinity_ = {};   // the vertex at infinity, whose numbers each inserter has for itself

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

extern template class BasicInserter<false>;
extern template class BasicInserter<true>;

}  // namespace rbpa::space
