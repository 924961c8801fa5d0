// What: finds the neighbors of triangles that fill groups of polygons.
#pragma once

#include "rbpa/base/run/steps.h"
#include "rbpa/fill/filling.h"

namespace rbpa {

/// Computes `filling.neighbors`, and replaces previous entries.
/// Requires: `triangles` and `groups` are filled in; the triangles of one group meet in whole edges.
/// Throws:   Cancelled.
/// Cost:     n log n.
void link(Filling& filling, Steps& step);

}  // namespace rbpa
