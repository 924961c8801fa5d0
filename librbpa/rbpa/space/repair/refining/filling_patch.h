// What:   refines the triangles that fill one hole.
// Law:    a function of the patch, including the order of its vertices and triangles.
// Source: Liepa, Filling holes in meshes (2003).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/base/mesh.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

using Vector = Vector3<double>;

inline double length(const Vector& v) { return std::sqrt(dot(v, v)); }

/// The weights of a triangle v a b at its corner v.
struct CornerWeights {
  double to_a = 0, to_b = 0;  ///< half cotangents of the angles at b and at a
  double area = 0;            ///< area of the part of the triangle that is nearest to v
  Vector normal{};            ///< normal of the triangle; its length is twice the area

  CornerWeights(const Vector& v, const Vector& a, const Vector& b) : normal(cross(minus(a, v), minus(b, v))) {
    const double twice = length(normal);
    if (!(twice > 0)) return;
    const Vector va = minus(a, v), vb = minus(b, v), ab = minus(b, a);
    const double at_v = dot(va, vb), at_a = -dot(va, ab), at_b = dot(vb, ab);  // cosines, each times two sides
    to_a = at_b / twice / 2;
    to_b = at_a / twice / 2;
    if (at_v < 0)
      area = twice / 4;
    else if (at_a < 0 || at_b < 0)
      area = twice / 8;
    else
      area = (dot(va, va) * to_a + dot(vb, vb) * to_b) / 4;
  }
};

/// Sums of area and curvature over the triangles around a vertex (Meyer, Desbrun, Schröder, Barr, Discrete
/// differential-geometry operators for triangulated 2-manifolds, 2003).
struct FanCurvature {
  Vector sum{};     ///< sum of weights times edges: the area times the curvature, along the normal
  Vector normal{};  ///< sum of the triangles' normals, of any length
  double area = 0;

  void add(const Vector& v, const Vector& a, const Vector& b) {
    const CornerWeights of(v, a, b);
    sum = plus(sum, plus(times(of.to_a, minus(a, v)), times(of.to_b, minus(b, v))));
    normal = plus(normal, of.normal);
    area += of.area;
  }
  /// Returns twice the mean curvature times the area. The result is below 0 if the surface bends away from its normal,
  /// as the surface of a ball does.
  double bend() const {
    const double size = length(normal);
    return size > 0 ? dot(sum, normal) / size : 0;
  }
};

/// The input of a patch. The vertices of the rim are numbered from 0.
struct FillingRim {
  std::vector<Vector> places;         ///< places of the vertices, all different
  std::vector<double> scales;         ///< for each vertex: mean length of its edges outside of the patch
  std::vector<FanCurvature> outside;  ///< for each vertex: sum over its triangles outside of the patch, for curvature
  /// For each vertex: twice the mean curvature over the two rings of vertices outside; only vertices count that
  /// triangles surround, none of them in the patch. Absent if no vertex counts.
  std::vector<std::optional<double>> bend;
  std::vector<bool> is_inner;  ///< for each vertex: whether triangles surround it entirely
  Surface triangles;           ///< corners are vertices; glued; lowest corner first, sorted
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< edges of vertices, outside of the patch; low < high
};

class FillingPatch {
 public:
  /// Keeps a reference to `rim`.
  explicit FillingPatch(const FillingRim& rim);

  /// Adds vertices until triangles are about as large as the rim's edges suggest, or at least `most` are added.
  /// Throws: Cancelled.
  void refine(std::size_t most, meshops::Steps& step);
  /// Moves the added vertices so that the surface is smooth across the rim, as curved there as outside, and of harmonic
  /// curvature inside. Returns false, and moves nothing, if the equations determine no places. Throws: Cancelled.
  bool make_smooth(meshops::Steps& step);

  std::size_t added() const { return between_.size(); }
  Vector place(std::size_t added) const;
  /// Returns, for each added vertex, the three vertices between which it was added. Numbers of rim vertices come first,
  /// then those of added vertices.
  const std::vector<std::array<std::uint32_t, 3>>& between() const { return between_; }
  std::vector<std::array<std::uint32_t, 3>> triangles() const;
  /// Returns whether a triangle has no area in double precision.
  bool is_degenerate() const;

 private:
  using Vertex = Mesh::VertexHandle;
  using Edge = Mesh::EdgeHandle;
  using Halfedge = Mesh::HalfedgeHandle;

  Vector at(Vertex v) const;
  std::uint32_t name(Vertex v) const { return names_[static_cast<std::size_t>(v.idx())]; }
  bool split_large(meshops::Steps& step);
  bool is_large(Mesh::FaceHandle f) const;
  void flip_all(meshops::Steps& step);
  std::optional<std::vector<double>> bends() const;
  std::optional<double> most_bend() const;
  bool bend_like(const std::vector<double>& bends, meshops::Steps& step, double& farthest);
  bool is_better_flipped(Edge e) const;
  std::array<Vector, 3> corners(Mesh::FaceHandle f) const;

  const FillingRim& rim_;
  Mesh mesh_;
  // For each mesh vertex, its number. Several mesh vertices have the number of one rim vertex if fans meet there.
  std::vector<std::uint32_t> names_;
  std::vector<double> scales_;  // wanted length of edges at each vertex, by number
  std::vector<std::array<std::uint32_t, 3>> between_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges_;  // all edges, also outside, by numbers of vertices
};

}  // namespace rbpa::space
