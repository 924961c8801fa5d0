// What: the dual complex of discs in the plane, and the closed curves of arcs that bound the union of the discs.
// How:  simplices are in the complex if the power of their orthocenter is below 0, and no disc beside them conflicts;
//       so discs that only touch are not connected. Two additions change no area: discs of one component that touch
//       have an edge, which separates what is on both sides; and triangles whose circles meet in one point, with
//       nothing else between the edges around them, fill it. Around a disc, the arc between two consecutive edges of
//       the complex is on the boundary unless a triangle of the complex is between them. Components of the complex and
//       regions of its complement form a tree, with the unbounded region as root; each curve is a link of the tree,
//       and separates a component from a region. The link toward the root is the outer curve of its component, the
//       others bound holes.
// Law:  exact.
// Cost: linear; n log n in the edges to number them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/balls/regular_triangulation.h"

namespace rbpa::space {

/// A closed curve of the boundary: the halfedges of the complex at which its arcs begin, in order. A disc that is alone
/// has a curve without halfedges.
struct ArcCurve {
  std::vector<std::uint32_t> halfedges;
  std::uint32_t disc = 0;       // disc of the first arc
  std::uint32_t component = 0;  // number of the component
  std::uint32_t region = 0;     // region of the complement beside the curve
  bool is_hole = true;
};

/// Edge e of the triangulation has the halfedges 2e, from its lower to its higher end, and 2e + 1. The face of a
/// halfedge is the triangle on its left, or `none` outside of the triangulation.
class DiscComplex {
 public:
  static constexpr std::uint32_t none = RegularTriangulation::none;

  /// Requires: centers with z = 0; `regular` is the regular triangulation of the discs, and has no tetrahedra.
  DiscComplex(std::span<const Point3> centers, std::span<const double> radii, const RegularTriangulation& regular,
              Steps& step);

  std::size_t halfedges() const { return face_.size(); }
  std::uint32_t from(std::uint32_t h) const { return ends_[h / 2][h % 2]; }
  std::uint32_t to(std::uint32_t h) const { return ends_[h / 2][1 - h % 2]; }
  bool has_edge(std::uint32_t h) const { return has_edge_[h / 2] != 0; }
  bool has_disc(std::uint32_t i) const { return has_disc_[i] != 0; }
  /// Returns whether the triangle on the left of h is in the complex.
  bool has_face(std::uint32_t h) const { return face_[h] != none && triangle_[face_[h]] == in; }
  /// Returns whether the arc from edge h to the next one around its origin is a single point, in which circles meet.
  bool is_point_after(std::uint32_t h) const;
  /// Returns the corner of the face of h across from h. Requires: h has a face.
  std::uint32_t apex(std::uint32_t h) const { return from(before_[h]); }
  /// Returns the next edge of the complex counter-clockwise around the origin of h.
  std::uint32_t next_around(std::uint32_t h) const {
    do h = before_[h] ^ 1U;
    while (!has_edge(h));
    return h;
  }

  /// Returns the curves in the order of DiscMeasures::boundary. Sets `component_of` to the number of the component of
  /// each disc, or none.
  std::vector<ArcCurve> curves(std::vector<std::uint32_t>& component_of, Steps& step) const;

 private:
  void number_edges(std::span<const Point3> centers, std::span<const std::array<std::uint32_t, 4>> flat, Steps& step);
  void close_outside(std::size_t discs);
  void decide(std::span<const Point3> centers, std::span<const double> radii, Steps& step);
  /// Returns the triangle on the left of h; the number of triangles if there is none, or h is `none`.
  std::uint32_t region_of(std::uint32_t h) const {
    return h == none || face_[h] == none ? static_cast<std::uint32_t>(triangles_) : face_[h];
  }
  meshops::DisjointSets regions(Steps& step) const;
  void fill_points(Steps& step);
  std::vector<ArcCurve> traced(std::vector<std::uint32_t>& lowest, Steps& step) const;

  std::vector<std::array<std::uint32_t, 2>> ends_;  // of each edge, ascending
  std::vector<std::uint32_t> face_, before_;        // of each halfedge
  std::size_t triangles_ = 0;
  /// Whether a triangle is in the complex; `point` if it is not and has the power 0: its circles meet in one point.
  enum Triangles : std::uint8_t { out, point, in };
  std::vector<Triangles> triangle_;
  std::vector<std::uint8_t> has_edge_, has_disc_;
  std::vector<std::uint32_t> halfedge_;  // of each disc: one that begins there, or none
};

}  // namespace rbpa::space
