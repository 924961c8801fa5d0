// What: maps a drawing to the pixels of a canvas, with y downward.
// Law:  any finite coordinates fit, however large, small or flat. A drawing gives the same numbers on every machine.
#pragma once

#include <vector>

#include "picture/drawing.h"
#include "picture/style.h"

namespace rbpa::app {

struct Pixel {
  double x, y;
};

/// A drawing with the positions of its points on the canvas.
struct Scene {
  int width;
  int height;
  std::vector<Pixel> at;  ///< position of each point of the drawing
  Strokes strokes;
  const Drawing* drawing;
  double pixel_size;  ///< in units of the coordinates; 0 if all points are equal, infinite beyond the range of a double
  Point corner;       ///< coordinates of the upper left corner of the canvas; may be infinite too
};

constexpr int least_width = 64;
constexpr int greatest_width = 8192;

/// Returns the scene of a drawing, which refers to the drawing. Both axes have one scale. The height follows the
/// points, from about 0.18 to 1.94 times the width. Requires: least_width ≤ width ≤ greatest_width. Cost: linear.
Scene place(const Drawing& drawing, int width);

}  // namespace rbpa::app
