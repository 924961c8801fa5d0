// What: points from a file of any format we read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/columns.h"
#include "io/foreground.h"
#include "io/formats.h"
#include "rbpa/core/point.h"

namespace rbpa::app {

struct PointSource {
  std::string path;  ///< "-" is standard input
  PointFormat format = PointFormat::text;
  Columns columns = {};   ///< of text
  PixelRule pixels = {};  ///< of images
};

/// The points in the order of the file, all finite. Throws BadInput naming the file, the line or the point, what was
/// found and what was expected; Failure; Cancelled.
std::vector<Point> read_points(const PointSource& source);

/// The same of the content of a file, which messages call `name`: the path does not count.
std::vector<Point> points_in(std::string_view bytes, const std::string& name, const PointSource& source);

}  // namespace rbpa::app
