// Every bit of a mesh's connectivity and status, to be compared.
#pragma once

#include <vector>

#include "meshops/core/connectivity.h"

namespace meshops::test {

/// The records of all elements, deleted ones included; equal when nothing at all was changed.
std::vector<int> snapshot(const Connectivity& mesh);

/// Whether it matters which of its halfedges an inner vertex names: any is as good.
enum class Named { compared, any };

/// The records of the live elements only: what is left in deleted ones does not count. Handles do.
std::vector<int> live_snapshot(const Connectivity& mesh, Named named = Named::compared);

}  // namespace meshops::test
