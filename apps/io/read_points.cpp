#include "io/read_points.h"

#include <algorithm>

#include "io/binary_points.h"
#include "io/failure.h"
#include "io/input_bytes.h"
#include "io/npy_points.h"
#include "io/off_points.h"
#include "io/pgm_points.h"
#include "io/ply_points.h"
#include "io/png_points.h"
#include "io/text_points.h"

namespace rbpa::app {

std::vector<Point> read_points(const PointSource& source) {
  const InputBytes input(source.path, "a file of points");
  return points_in(input.bytes(), input.name(), source);
}

std::vector<Point> points_in(std::string_view bytes, const std::string& name, const PointSource& source) {
  // No points may be meant; no bytes at all come from a command that failed before.
  if (bytes.empty()) bad_input(name, "an empty file", "points");
  switch (source.format) {
    case PointFormat::npy:
      return read_npy_points(bytes, name);
    case PointFormat::off:
      return read_off_points(bytes, name);
    case PointFormat::ply:
      return read_ply_points(bytes, name);
    case PointFormat::raw:
      return read_raw_points(bytes, name);
    case PointFormat::png:
      return read_png_points(bytes, name, source.pixels);
    case PointFormat::pgm:
      return read_pgm_points(bytes, name, source.pixels);
    case PointFormat::text:
      break;
  }
  return read_text_points(bytes, name, source.columns);
}

}  // namespace rbpa::app
