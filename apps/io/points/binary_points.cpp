#include "io/points/binary_points.h"

#include <algorithm>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"

namespace rbpa::app {

void require_finite(const Point& p, std::size_t index, const std::string& name) {
  if (is_finite(p)) return;
  const double value = std::isfinite(p.x) ? p.y : p.x;
  bad_input(name + ": point " + std::to_string(index), in_quotes(ShortestText(value)), "a finite number");
}

namespace {

/// load_points() with `load_x(bytes)` and `load_y(bytes)` for the coordinates.
template <typename LoadX, typename LoadY>
std::vector<Point> load_all(const PointArray& array, const LoadX& load_x, const LoadY& load_y,
                            const std::string& name) {
  std::vector<Point> points;
  points.reserve(array.count);
  // In blocks that stay in the nearest cache while they are made, filled and checked.
  constexpr std::size_t block = 1024;
  while (points.size() < array.count) {
    stop_if_interrupted();
    const std::size_t first = points.size(), last = std::min(first + block, array.count);
    points.resize(last);
    bool finite = true;
    for (std::size_t i = first; i < last; ++i) {
      points[i] = {load_x(array.first_x + i * array.stride), load_y(array.first_y + i * array.stride)};
      finite &= is_finite(points[i]);
    }
    for (std::size_t i = first; i < last && !finite; ++i) require_finite(points[i], array.first_index + i, name);
  }
  return points;
}

}  // namespace

std::vector<Point> load_points(const PointArray& array, const std::string& name) {
  const auto load_of = [&]<typename T>(T) {
    return [](const char* bytes) { return static_cast<double>(load<T>(bytes, std::endian::native)); };
  };
  if (array.order == std::endian::native && array.x_type == array.y_type) {
    if (array.x_type == Scalar::float64) return load_all(array, load_of(double{}), load_of(double{}), name);
    if (array.x_type == Scalar::float32) return load_all(array, load_of(float{}), load_of(float{}), name);
  }
  const auto load_any = [&](Scalar type) {
    return [type, &array](const char* bytes) { return load_number(type, bytes, array.order); };
  };
  return load_all(array, load_any(array.x_type), load_any(array.y_type), name);
}

std::vector<Point> read_raw_points(std::string_view bytes, const std::string& name) {
  if (bytes.size() % 16 != 0) bad_input(name, counted(bytes.size(), "byte"), "a multiple of 16 (pairs of float64)");
  return load_points(
      {bytes.size() / 16, bytes.data(), bytes.data() + 8, 16, Scalar::float64, Scalar::float64, std::endian::little},
      name);
}

}  // namespace rbpa::app
