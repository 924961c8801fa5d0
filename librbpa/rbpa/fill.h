// What:   triangulates polygons with holes by an advancing front, with edges of about a given length.
// Law:    the triangles cover the polygons, meet in whole edges, and have the same boundary as the polygons. All
//         decisions are exact, so this holds for every valid multipolygon (validity.h), and for groups of them. The
//         triangles do not depend on the direction of the rings, their first points, or their order.
// Cost:   about linear in the triangles, n log n in the boundary.
// Note:   this header includes nothing of OpenMesh, but the front advances on a halfedge mesh: a library with
//         RBPA_ARRAYS_ONLY has no fill(). filling_mesh.h makes a halfedge mesh of the result.
// Source: Lo, A new mesh generation scheme for arbitrary planar domains (1985); George, Séveno, The advancing-front
//         mesh generation method revisited (1994); docs/explanation/plane.md, sections 26 and 27.
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/fill/filling.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// Fills polygons with triangles whose edges are about `options.size` long. The rings of `polygons` are indices into
/// `points`. A ring may begin anywhere, have either orientation, and repeat a point in a row; rings may touch at single
/// points, and polygons may lie in holes of others. A polygon without points has no triangle. Of equal points the one
/// of lowest index is used. A point at which a ring touches an edge becomes a vertex of that edge's ring. A point that
/// fill() adds on an edge is rounded to doubles, and may therefore lie beside the edge.
/// Requires: each group (FillOptions::groups) is a valid multipolygon.
/// Throws:   InvalidInput for coordinates that are not finite; for a group that is not valid, with the text of
///           why_invalid() (validity.h); for groups that do not ascend from 0; for a size or grade that is not a finite
///           number above 0, except an infinite `options.size` without grade and sizes; for an estimate above 500
///           million triangles; for coordinates too far apart in magnitude. Cancelled; exceptions of the callbacks.
RBPA_API Filling fill(std::span<const Point> points, std::span<const Polygon> polygons, const FillOptions& options);

}  // namespace rbpa
