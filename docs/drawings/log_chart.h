// What: draws curves over logarithmic axes.
// Law:  ticks are 1, 2 and 5 times powers of ten, or powers of ten alone if these are enough.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "drawings/canvas.h"

namespace figures {

struct Curve {
  std::string_view name;
  std::string_view color;
  bool dashed = false;
  std::vector<Place> points = {};  ///< values, above 0, ascending in x
};

struct LogChart {
  std::string heading, below;
  std::function<std::string(double)> x_label, y_label;  ///< the text at a tick
  std::vector<Curve> curves;
};

/// Draws a chart. The axes meet at the lower left of a box of this size, whose upper left corner is given; headings and
/// labels stand around it.
void draw(Canvas& canvas, const LogChart& chart, Place upper_left, Place size);

/// Draws the names of curves in a row.
void draw_legend(Canvas& canvas, const std::vector<Curve>& curves, Place at);

/// Returns a value with at most three digits and a unit of thousands: "200 µs", "1.5 s".
std::string with_unit(double value, std::string_view unit);

}  // namespace figures
