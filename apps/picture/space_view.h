// What: points of space as seen from a direction that follows from them, moved to the pixels of a canvas.
// Law:  a function of the set of points, up to rounding, and of no order; any finite coordinates fit.
// How:  orthographic; the shortest principal axis of the points points to the viewer, y or z is upright, whichever is
//       not looked along, and the view is then turned by 25 degrees to the side and 20 from above, so that what is flat
//       or straight shows its depth.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::app {

struct SpaceView {
  int width;
  int height;
  std::vector<std::array<double, 3>>
      at;  ///< of each point: x to the right, y down, and depth towards the viewer, in pixels
};

/// Requires: width within the bounds of scene.h. The height follows the points, from a fourth to twice the width.
SpaceView view_of(std::span<const Point3> points, int width);

}  // namespace rbpa::app
