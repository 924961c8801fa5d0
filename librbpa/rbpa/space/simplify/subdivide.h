// What:   subdivides a halfedge mesh of triangles in place: Loop's rule makes four triangles of one, the √3 rule three,
//         and both move vertices toward a smooth surface.
// Law:    components, genus, orientation and Betti numbers stay, closed stays closed, and each boundary curve stays one
//         curve, whose places depend on that curve alone: by Loop's rule it approaches a cubic B-spline, by the √3 rule
//         it stays as it is. New places are means of old ones with positive weights. A surface with other numbers of
//         vertices, edges and faces becomes the same surface, to the last bit of each place.
// Cost:   linear in the triangles of the result.
// Source: Loop, Smooth subdivision surfaces based on triangles (1987); Kobbelt, √3-subdivision (2000).
#pragma once

#include <cstddef>
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

enum class SubdivisionRule {
  loop,  ///< each edge is split, and four triangles come of one
  sqrt3  ///< each triangle is split in three, and inner edges are flipped; boundary edges are never split
};

struct SubdivisionOptions {
  SubdivisionRule rule = SubdivisionRule::loop;
  unsigned times = 1;                   ///< number of times that the rule is applied
  std::size_t most_faces = 20'000'000;  ///< limit: a subdivision that makes more triangles is refused
  GoOn go_on = {};                      ///< progress; false ends the run with Cancelled
};

/// Subdivides a mesh, and moves the places of its vertices. Elements keep their numbers, and new ones follow, with
/// default values of properties; a vertex keeps all properties but its place. Isolated vertices stay. A mesh with
/// faces then has status of every kind.
/// Requires: a sound mesh of triangles, in which no two edges join the same vertices; `places` has a position for each
///           vertex by index, finite if the vertex is not deleted.
/// Throws:   ContractViolation unless there is one place for each vertex and each face is a triangle. InvalidInput when
///           a place is not finite, a vertex has several fans, or more than `most_faces` triangles would be made: the
///           mesh is then unchanged. Cancelled: the rule was applied to mesh and places less often.
RBPA_API void subdivide(meshops::Connectivity& mesh, std::vector<Point3>& places, const SubdivisionOptions& options);

/// Subdivides a mesh whose vertices have points, as above, with `places` = places_of(mesh).
template <meshops::HasPoints AnyMesh>
void subdivide(AnyMesh& mesh, const SubdivisionOptions& options) {
  using Number = std::remove_cvref_t<decltype(std::declval<AnyMesh&>().point(meshops::Vertex())[0])>;
  std::vector<Point3> places = places_of(mesh);
  const auto set_points = [&] {
    for (std::size_t v = 0; v < places.size(); ++v)
      mesh.set_point(
          meshops::Vertex(static_cast<int>(v)),
          {static_cast<Number>(places[v].x), static_cast<Number>(places[v].y), static_cast<Number>(places[v].z)});
  };
  try {
    subdivide(mesh, places, options);
  } catch (...) {
    set_points();  // after Cancelled, the mesh has the vertices of the times before
    throw;
  }
  set_points();
}

}  // namespace rbpa
