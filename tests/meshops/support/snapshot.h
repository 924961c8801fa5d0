// Records every bit of the connectivity and status of a mesh, for comparison.
#pragma once

#include <vector>

#include "meshops/core/connectivity.h"

namespace meshops::test {

/// Returns the records of all elements, deleted ones included; equal when nothing was changed.
std::vector<int> snapshot(const Connectivity& mesh);

/// Choice: compare the halfedge to which an inner vertex refers, or ignore it because any halfedge is valid.
enum class Named { compared, any };

/// Returns the records of live elements only, with their handles; records of deleted elements do not count.
std::vector<int> live_snapshot(const Connectivity& mesh, Named named = Named::compared);

}  // namespace meshops::test
