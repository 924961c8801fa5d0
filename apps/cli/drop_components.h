// What: components of a surface left out, with their curves, and what is known about them counted.
#pragma once

#include <span>
#include <vector>

#include "cli/surface_report.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"
#include "rbpa/surface_components.h"

namespace rbpa::app {

/// `kept`: of each component.
void drop_components(std::span<const Point3> points, const std::vector<bool>& kept, Surface& surface,
                     SurfaceComponents& components, SurfaceFacts& facts);

}  // namespace rbpa::app
