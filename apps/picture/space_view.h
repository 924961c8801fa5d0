// What: views points in space, on the pixels of a canvas, from a direction that follows from the points.
// Law:  up to rounding, the view depends on the set of points, not on their order. Any finite coordinates fit.
// How:  the view is orthographic. The shortest principal axis of the points points to the viewer; y or z, whichever is
//       not the direction of view, is upright. The view is then turned by 25 degrees to the side and 20 from above, so
//       that flat and straight sets show their depth.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::app {

struct SpaceView {
  int width;
  int height;
  /// Position of each point, in pixels: x to the right, y down, and the depth, which grows toward the viewer.
  std::vector<std::array<double, 3>> at;
};

/// Returns the view of `points`. The height follows the points, from a quarter to twice the width. Requires:
/// least_width ≤ width ≤ greatest_width (scene.h).
SpaceView view_of(std::span<const Point3> points, int width);

}  // namespace rbpa::app
