#include "io/points/foreground.h"

#include <algorithm>
#include <array>

#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

constexpr std::size_t pixel_limit = std::size_t{1} << 30U;  // as many points are too many

Shade ground_of(const Shades& image) {
  std::array<std::size_t, 3> count{};
  const auto add = [&](std::size_t row, std::size_t column) {
    ++count[static_cast<std::size_t>(image.pixels[row * image.width + column])];
  };
  for (std::size_t column = 0; column < image.width; ++column) {
    add(0, column);
    if (image.height > 1) add(image.height - 1, column);
  }
  for (std::size_t row = 1; row + 1 < image.height; ++row) {
    add(row, 0);
    if (image.width > 1) add(row, image.width - 1);
  }
  const auto pixels_of = [&](Shade shade) { return count[static_cast<std::size_t>(shade)]; };
  Shade ground = Shade::clear;
  for (const Shade other : {Shade::light, Shade::dark})
    if (pixels_of(other) > pixels_of(ground)) ground = other;
  return ground;
}

}  // namespace

void require_image_size(std::size_t width, std::size_t height, const std::string& name) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) bad_input(name, size, "at least 1 x 1");
  if (width >= pixel_limit || height >= pixel_limit || width * height >= pixel_limit)
    bad_input(name, size, "fewer than 2^30 of them");
}

std::vector<Point> foreground_points(const Shades& image, const std::optional<Foreground>& foreground) {
  std::array<bool, 3> wanted{false, true, true};
  if (foreground)
    wanted[static_cast<std::size_t>(*foreground == Foreground::dark ? Shade::light : Shade::dark)] = false;
  else
    wanted[static_cast<std::size_t>(ground_of(image))] = false;

  const auto is_wanted = [&](Shade shade) { return wanted[static_cast<std::size_t>(shade)]; };
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(std::count_if(image.pixels.begin(), image.pixels.end(), is_wanted)));
  for (std::size_t row = 0; row < image.height; ++row) {
    stop_if_interrupted();
    for (std::size_t column = 0; column < image.width; ++column)
      if (is_wanted(image.pixels[row * image.width + column]))
        points.push_back({static_cast<double>(column) + 0.5, static_cast<double>(image.height - row) - 0.5});
  }
  return points;
}

}  // namespace rbpa::app
