// What: views points in space from a direction that follows from them, on the pixels of a canvas.
// Law:  a function of the set of points, up to rounding, in whatever order they come; any finite coordinates fit.
// How:  orthographic. The shortest principal axis of the points points to the viewer; y or z is upright, whichever is
//       not the direction of view. The view is then turned by 25 degrees to the side and 20 from above, so that flat
//       and straight sets show their depth.
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
