// What: holds a solid alpha complex as a halfedge mesh, with the input point of each vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/mesh.h"
#include "rbpa/base/triangle.h"

namespace rbpa {

/// A solid alpha complex, the Delaunay triangles of circumradius ≤ alpha, as an oriented 2-manifold with boundary.
/// Where the complex touches itself at a point (a pinch), each fan of triangles has a vertex of its own; all of these
/// vertices have the same input point. Of equal input points, only the lowest index occurs, except in `duplicates`.
struct SolidAlphaComplex {
  Mesh mesh;                               ///< faces counter-clockwise; no isolated and no deleted elements; z = 0
  std::vector<std::uint32_t> input_index;  ///< for each vertex of the mesh, the index of its input point
  std::vector<std::uint32_t> isolated;     ///< input indices of distinct points in no triangle, ascending
  std::vector<Duplicate> duplicates;       ///< ascending by index
  std::size_t distinct = 0;                ///< number of distinct points
};

/// Returns the triangles of a complex as input indices in canonical order: counter-clockwise, the smallest index first,
/// in lexicographic order.
/// Requires: a complex that rbpa() or hrbpa() returned; not checked.
/// Cost:     linear in the faces and the greatest input index.
RBPA_API std::vector<Triangle> triangles(const SolidAlphaComplex& complex);

}  // namespace rbpa
