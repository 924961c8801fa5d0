// What:   simplifies a triangle mesh in space by quadric errors: fewer triangles, near the old ones.
// Law:    topology stays as meshops::simplify() keeps it. No triangle turns by a right angle or more in one collapse,
//         and on request none begins to cross another one; both are decided exactly on the points that the mesh gets.
//         The result does not depend on the numbers of vertices and faces, if vertices on one point, such as those of
//         a pinch, have neighbors on different points.
// Cost:   that of meshops::simplify(), with some hundred operations for each cost, and microseconds for each collapse.
// Source: Garland and Heckbert (1997); Trettner and Kobbelt (2020): see quadric.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/simplify/simplify.h"
#include "meshops/stellar/split_hooks.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/simplify/quadric.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa {

namespace space {
class LiveTriangles;
}

struct QuadricOptions {
  /// Weight of the planes that stand on boundary edges, as a multiple of the length of the edge, where the plane of a
  /// triangle weighs the square root of the triangle's area. The weight keeps boundary curves in place.
  double boundary_weight = 20;
  /// Weight of the planes that stand on sharp edges, one for each of the two triangles. An edge is sharp if the normals
  /// of its triangles differ by more than `sharp_angle`, in degrees.
  double sharp_weight = 0.5;
  double sharp_angle = 60;
  /// Standard deviation of the normals, in radians. If above 0, the least error is at one point even where planes do
  /// not determine it, and vertices in a plane stay evenly spread.
  double normal_deviation = 1e-3;
  /// Whether a vertex moves to the end of its edge with the lesser error, so that all vertices are vertices of the
  /// input. Otherwise a vertex moves to the place of the least error.
  bool at_ends = false;
  /// Whether places are rounded to float, as for a mesh whose points have float coordinates.
  bool single_precision = false;
  /// Forbids collapses after which a triangle would cross another one, or touch it elsewhere than in common corners and
  /// sides, as defined by crossing_triangles(). A forbidden edge is tried again after a change near it.
  bool no_crossings = false;
};

/// Policy of meshops::simplify() that keeps a place and a quadric for each vertex.
class RBPA_API QuadricPolicy {
 public:
  /// Computes the quadrics of a mesh of triangles.
  /// Requires: a sound mesh; `places` has a finite position for each vertex, by index; weights and `normal_deviation`
  ///           are finite and at least 0; `sharp_angle` is from 0 to 180.
  /// Throws:   ContractViolation unless the options meet this and there is one place for each vertex; with
  ///           `no_crossings` also if a place is not finite. Without `no_crossings`, a place that is not finite makes a
  ///           cost that simplify() refuses.
  /// Cost:     n log n for n vertices.
  QuadricPolicy(const meshops::Connectivity& mesh, std::vector<Point3> places, const QuadricOptions& options = {});
  QuadricPolicy(QuadricPolicy&&) noexcept;
  ~QuadricPolicy();

  /// Returns the error at the place of the edge: the sum of √area · distance² over the triangles that were merged
  /// into its ends, each counted up to three times, and of the terms of boundary edges, sharp edges and
  /// `normal_deviation`.
  /// Lengths are multiplied by scale(). The error never falls when ends are merged, unless `at_ends`.
  double cost(const meshops::Connectivity& mesh, meshops::Edge e) const;
  /// Returns the place to which the edge collapses: an end with `at_ends`, otherwise the place of the least error.
  Point3 place(const meshops::Connectivity& mesh, meshops::Edge e) const;
  /// Returns whether turns() and crosses() are both false for this collapse.
  bool allows(const meshops::Connectivity& mesh, meshops::Edge e, const Point3& place) const {
    return !turns(mesh, e, place) && !crosses(mesh, e, place);
  }
  /// Returns whether a triangle at the ends of the edge turns by a right angle or more, loses its area, or gets two
  /// corners at one place.
  bool turns(const meshops::Connectivity& mesh, meshops::Edge e, const Point3& place) const;
  /// Returns whether a triangle at the ends of the edge would cross another one; false without `no_crossings`.
  bool crosses(const meshops::Connectivity& mesh, meshops::Edge e, const Point3& place) const;
  /// Returns the rank of the vertex among all, by the points of the beginning; on one point, by those of the neighbors.
  std::uint32_t key(const meshops::Connectivity&, meshops::Vertex v) const { return rank_[index(v)]; }
  /// Returns the end of the edge that lies at the place; if neither does, the end of the lesser key.
  meshops::Vertex survivor(const meshops::Connectivity& mesh, meshops::Edge e, const Point3& place) const;
  /// Moves the surviving vertex to the place, and adds the quadric of the removed vertex to that of the survivor.
  void merge(const meshops::Connectivity& mesh, const meshops::WeldEffect& effect, const Point3& place);

  /// Returns the place of each vertex by index; for a removed vertex, some former place.
  const std::vector<Point3>& places() const& { return places_; }
  std::vector<Point3> places() && { return std::move(places_); }

  /// The place and the quadric of a vertex at some time.
  struct State {
    meshops::Vertex vertex;
    Point3 place;
    Quadric quadric;
  };
  /// Returns the states of all vertices of the mesh as they are now.
  std::vector<State> states(const meshops::Connectivity& mesh) const;
  /// Restores earlier states, and multiplies each quadric by the weight of its vertex, by index: a vertex of a greater
  /// weight stays nearer to the triangles around it.
  /// Requires: the mesh is as it was when states() returned them; weights are positive and finite (not checked).
  void restore(const meshops::Connectivity& mesh, const std::vector<State>& states, const std::vector<double>& weights);

  /// Returns the power of two by which lengths are multiplied in errors, so that the mesh has about the size 1.
  double scale() const { return scale_; }

  const bool costs_grow;  ///< whether a merge never lowers a cost; for meshops::simplify()

 private:
  struct Target {
    Point3 place;
    double error;
  };
  static std::size_t index(meshops::Vertex v) { return static_cast<std::size_t>(v.idx()); }
  std::pair<meshops::Vertex, meshops::Vertex> ends(const meshops::Connectivity& mesh, meshops::Edge e) const;
  Target target(const meshops::Connectivity& mesh, meshops::Edge e) const;
  Point3 local(const Point3& p) const;
  Point3 unscaled(const Point3& local) const;

  QuadricOptions options_;
  std::vector<Point3> places_;
  std::vector<Quadric> quadrics_;
  std::vector<std::uint32_t> rank_;
  std::unique_ptr<space::LiveTriangles> triangles_;  // with `no_crossings` only
  Point3 center_;
  double scale_ = 1;
};

/// QuadricPolicy that also moves the points of the mesh. The policy of simplify(), and the base of policies with
/// conditions or costs of their own. A derived class with a cost() of its own declares
/// `static constexpr bool costs_grow = false`, and one with a merge() of its own calls that of this class.
template <meshops::HasPoints AnyMesh>
class MeshQuadrics : public QuadricPolicy {
 public:
  /// Computes the quadrics of the mesh, at the positions of its vertices; places are rounded to the numbers of its
  /// points.
  /// Requires: as QuadricPolicy::QuadricPolicy().
  explicit MeshQuadrics(const AnyMesh& mesh, const QuadricOptions& options = {})
      : QuadricPolicy(mesh, places_of(mesh), rounded_for_points(options)) {}

  void merge(AnyMesh& mesh, const meshops::WeldEffect& effect, const Point3& place) {
    QuadricPolicy::merge(mesh, effect, place);
    mesh.set_point(effect.survivor,
                   {static_cast<Number>(place.x), static_cast<Number>(place.y), static_cast<Number>(place.z)});
  }

 private:
  using Number = typename OpenMesh::vector_traits<typename AnyMesh::Point>::value_type;
  static QuadricOptions rounded_for_points(QuadricOptions options) {
    options.single_precision = options.single_precision || std::is_same_v<Number, float>;
    return options;
  }
};

/// Simplifies a mesh in place, down to the limits of `options`. Deleted elements stay in the mesh until
/// garbage_collection(). `options.cost` is in units of QuadricPolicy::cost().
/// Requires: simplify_blocker(mesh) is empty; a sound mesh with three finite coordinates for each vertex.
/// Throws:   ContractViolation that names a vertex whose coordinates are not finite, or an option of `quadrics` that is
///           out of its range; as meshops::simplify().
template <meshops::HasPoints AnyMesh, typename Visitor = meshops::SimplifyVisitor>
meshops::SimplifyResult simplify(AnyMesh& mesh, const meshops::SimplifyOptions& options,
                                 const QuadricOptions& quadrics = {}, Visitor&& visitor = {}) {
  meshops::detail::enforce("simplify", meshops::simplify_blocker(mesh));
  const std::vector<Point3> places = places_of(mesh);
  for (std::size_t v = 0; v < places.size(); ++v)
    meshops::require(is_finite(places[v]), "simplify: found coordinates of vertex ", static_cast<long long>(v),
                     " that are not finite, expected numbers");
  return meshops::simplify(mesh, MeshQuadrics<AnyMesh>(mesh, quadrics), options, visitor);
}

}  // namespace rbpa
