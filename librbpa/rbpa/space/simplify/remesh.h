// What:   remeshes a halfedge mesh of triangles in place: edges of about one length, or of lengths that follow the
//         curvature or a list, six at each inner vertex, and triangles near the old ones.
// Law:    components, genus, orientation and Betti numbers stay, each boundary curve stays one curve, and closed
//         components stay closed. Sharp edges and boundary curves stay curves; their ends and corners stay in place. No
//         operation turns a triangle by a right angle or more. These decisions are exact; places are rounded. The
//         result, numbers of vertices and faces included, does not depend on the numbers of the input, if vertices on
//         one point have neighbors on different points.
// Cost:   microseconds for each triangle in each round; with an error, tens of them.
// Source: Botsch and Kobbelt, A remeshing approach to multiresolution modeling (2004); for the curvature Dunyach,
//         Vanderhaeghe, Barthe, Botsch, Adaptive remeshing for real-time mesh deformation (2013).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/stellar/split_hooks.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa {

struct RemeshOptions {
  double length = 0;  ///< length of edges, in units of the places: above 0, at most the size of the mesh
  /// Length of edges at each vertex of the given mesh, by index; empty if it is `length` everywhere. Lengths above
  /// `length` count as `length`. From a vertex on, the length grows at most by half of the distance.
  std::span<const double> lengths = {};
  /// Limit of the distance from the triangles of the beginning, above 0. Makes edges shorter where the surface curves,
  /// down to this distance, and makes no collapse, flip or move after which a triangle is not certified to be within
  /// the limit, or an edge of a curve within the limit of that curve. Only the rounding of places can exceed the limit.
  std::optional<double> error = {};
  unsigned rounds = 10;  ///< number of times that edges are split, collapsed and flipped, and vertices moved
  /// An edge is sharp if the normals of its triangles differ by more than this angle, in degrees. A vertex between two
  /// edges of a curve is a corner if the directions of the edges differ by more than this angle. At 180, no edge is
  /// sharp, and boundary curves have no corners.
  double sharp_angle = 60;
  bool keep_boundary = false;           ///< whether boundary edges and their vertices stay as they are
  std::size_t most_faces = 20'000'000;  ///< limit: a length that is expected to need more triangles is refused
  bool measured = false;                ///< bounds the distance from the triangles of the beginning
  bool single_precision = false;        ///< whether places are rounded to float, as for a mesh with such points
  GoOn go_on = {};                      ///< progress; false ends the run with Cancelled
};

/// Counts of a run.
struct Remeshing {
  std::size_t given = 0;      ///< number of triangles before
  std::size_t left = 0;       ///< number of triangles after
  std::size_t splits = 0;     ///< number of edges that were split
  std::size_t collapses = 0;  ///< number of edges that collapsed
  std::size_t flips = 0;      ///< number of edges that were flipped
  /// A distance from the triangles of the beginning that no point of the result exceeds, rounding included. It is at
  /// most 1.05 times the greatest distance, with rare exceptions, and at most options.error unless rounding exceeds it.
  /// Present if options.measured is set.
  std::optional<double> distance = {};
  /// Such a distance from the triangles of the result that no point of those of the beginning exceeds.
  std::optional<double> distance_back = {};
};

/// Remeshes a mesh, and replaces the places of its vertices by those of the new ones. In the result, vertices ascend by
/// their places, every fan of triangles has a vertex of its own, and nothing is marked deleted. Isolated vertices stay.
/// The mesh then has status of every kind, and its properties have default values.
/// Requires: a sound mesh of triangles, in which no two edges join the same vertices, except that vertices may have
///           several fans; `places` has a position for each vertex by index, finite if the vertex is not deleted.
/// Throws:   ContractViolation unless there is one place for each vertex and each face is a triangle, and as
///           meshops::build_mesh() throws it when edges join the same vertices. InvalidInput when a place is not
///           finite, a coordinate is beyond 1e60 (1e38 with single_precision), the angle is not from 0 to 180, the
///           number of `lengths` is not that of vertices, a length or the error is not from 1e-60 to 1e60, `length`
///           exceeds the diagonal of the mesh's box, or more than `most_faces` triangles would be needed. Cancelled. In
///           each case, the mesh and `places` are unchanged.
RBPA_API Remeshing remesh(meshops::Connectivity& mesh, std::vector<Point3>& places, const RemeshOptions& options);

/// Remeshes a mesh whose vertices have points, as above, with `places` = places_of(mesh).
template <meshops::HasPoints AnyMesh>
Remeshing remesh(AnyMesh& mesh, RemeshOptions options) {
  using Number = std::remove_cvref_t<decltype(std::declval<AnyMesh&>().point(meshops::Vertex())[0])>;
  options.single_precision = std::is_same_v<Number, float>;
  std::vector<Point3> places = places_of(mesh);
  const Remeshing counts = remesh(mesh, places, options);
  for (std::size_t v = 0; v < places.size(); ++v)
    mesh.set_point(
        meshops::Vertex(static_cast<int>(v)),
        {static_cast<Number>(places[v].x), static_cast<Number>(places[v].y), static_cast<Number>(places[v].z)});
  return counts;
}

}  // namespace rbpa
