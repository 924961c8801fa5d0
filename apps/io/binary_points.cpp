#include "io/binary_points.h"

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"

namespace rbpa::app {

void require_finite(const Point& p, std::size_t index, const std::string& name) {
  if (is_finite(p)) return;
  const double value = std::isfinite(p.x) ? p.y : p.x;
  bad_input(name + ": point " + std::to_string(index), in_quotes(ShortestText(value)), "a finite number");
}

std::vector<Point> load_points(const PointArray& array, const std::string& name) {
  std::vector<Point> points(array.count);
  for (std::size_t i = 0; i < array.count; ++i) {
    if (i % 65536 == 0) stop_if_interrupted();
    const std::size_t offset = i * array.stride;
    points[i] = {load_number(array.x_type, array.first_x + offset, array.order),
                 load_number(array.y_type, array.first_y + offset, array.order)};
    require_finite(points[i], i, name);
  }
  return points;
}

std::vector<Point> read_raw_points(std::string_view bytes, const std::string& name) {
  if (bytes.size() % 16 != 0)
    bad_input(name, std::to_string(bytes.size()) + " bytes", "a multiple of 16 (pairs of float64)");
  return load_points({bytes.size() / 16, bytes.data(), bytes.data() + 8, 16, Scalar::float64, Scalar::float64,
                      std::endian::little},
                     name);
}

}  // namespace rbpa::app
