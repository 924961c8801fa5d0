// What: the length that an edge should have at each vertex: that of the options, less where the surface curves or where
//       the caller wants shorter ones.
// Source: Dunyach, Vanderhaeghe, Barthe, Botsch, Adaptive remeshing for real-time mesh deformation (2013).
#pragma once

#include <vector>

#include "meshops/core/connectivity.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/simplify/remesh.h"
#include "rbpa/space/simplify/remeshing/mesh_curves.h"

namespace rbpa::space {

/// Returns for each vertex the length that edges there should have, as a part of options.length, above 0 and at most 1;
/// an empty list if it is 1 everywhere. Between neighbors it grows by at most half of their distance. `lengths` has a
/// length for each vertex, or is empty. Edges on curves, at which the surface is sharp or ends, count as not curved.
std::vector<double> wanted_lengths(const meshops::Connectivity& mesh, const std::vector<Point3>& places,
                                   const MeshCurves& curves, const std::vector<double>& lengths,
                                   const RemeshOptions& options);

}  // namespace rbpa::space
