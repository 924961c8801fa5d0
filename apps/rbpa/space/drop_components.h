// What: drops components of a surface with their boundary curves, and counts what is dropped.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"
#include "rbpa/space/surface/surface_components.h"
#include "space/surface_report.h"

namespace rbpa::app {

/// Counts the components for which `kept` is false, their triangles, and the points that no other triangle has.
DroppedComponents dropped_components(std::span<const Point3> points, const std::vector<bool>& kept,
                                     const Surface& surface, const SurfaceComponents& components);

/// Drops the components for which `kept` is false from all arguments, and fills in facts.dropped.
void drop_components(std::span<const Point3> points, const std::vector<bool>& kept, Surface& surface,
                     SurfaceComponents& components, SurfaceFacts& facts);

}  // namespace rbpa::app
