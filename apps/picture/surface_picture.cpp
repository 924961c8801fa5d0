#include "picture/surface_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "io/interrupt.h"
#include "picture/picture.h"
#include "picture/space_view.h"
#include "picture/style.h"

namespace rbpa::app {
namespace {

using Place = std::array<double, 3>;

constexpr Color front_color{0xA9, 0xCD, 0xE6};
constexpr Color back_color{0xC9, 0xC2, 0xB8};
constexpr Color filled_color{0x9F, 0xD3, 0xB4};  // lighter than the boundary, greener than the surface
constexpr Color rim_color{0xE6, 0x9F, 0x00};
constexpr Color island_color{0xCC, 0x79, 0xA7};

/// A canvas of samples, each with a color and a depth. A sample shows the part nearest to the viewer of all that is
/// drawn on it.
class DepthCanvas {
 public:
  DepthCanvas(int width, int height) : width_(width), height_(height) {
    const auto row = static_cast<std::size_t>(width), count = row * static_cast<std::size_t>(height);
    depths_.reserve(count);
    colors_.reserve(count);
    while (depths_.size() < count) {
      step_(row / 4);
      depths_.resize(depths_.size() + row, -std::numeric_limits<float>::infinity());
      colors_.resize(colors_.size() + row, background_color);
    }
  }

  void put(int x, int y, double depth, const Color& color) {
    const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    if (static_cast<float>(depth) <= depths_[i]) return;
    depths_[i] = static_cast<float>(depth);
    colors_[i] = color;
  }

  /// Draws the triangle on the samples whose centers it contains.
  void triangle(const Place& a, const Place& b, const Place& c, const Color& color) {
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area == 0) return;
    const double sign = area > 0 ? 1 : -1;
    const int y_end = inside(std::ceil(std::max({a[1], b[1], c[1]})), height_);
    const int x_begin = inside(std::floor(std::min({a[0], b[0], c[0]})), width_);
    const int x_end = inside(std::ceil(std::max({a[0], b[0], c[0]})), width_);
    for (int y = inside(std::floor(std::min({a[1], b[1], c[1]})), height_); y < y_end; ++y) {
      step_(1 + static_cast<std::size_t>(x_end - x_begin) / 8);
      for (int x = x_begin; x < x_end; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const double at_c = (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]);
        const double at_a = (c[0] - b[0]) * (py - b[1]) - (c[1] - b[1]) * (px - b[0]);
        const double at_b = area - at_a - at_c;
        if (sign * at_a < 0 || sign * at_b < 0 || sign * at_c < 0) continue;
        put(x, y, (at_a * a[2] + at_b * b[2] + at_c * c[2]) / area, color);
      }
    }
  }

  void disc(const Place& center, double radius, const Color& color) {
    const int y_end = inside(std::ceil(center[1] + radius), height_),
              x_end = inside(std::ceil(center[0] + radius), width_);
    step_(2 * static_cast<std::size_t>(radius));
    for (int y = inside(std::floor(center[1] - radius), height_); y < y_end; ++y)
      for (int x = inside(std::floor(center[0] - radius), width_); x < x_end; ++x) {
        const double dx = x + 0.5 - center[0], dy = y + 0.5 - center[1];
        if (dx * dx + dy * dy <= radius * radius) put(x, y, center[2], color);
      }
  }

  /// Draws a line as a row of discs.
  void line(const Place& from, const Place& to, double radius, const Color& color) {
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const int steps = 1 + static_cast<int>(2 * length / radius);
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      Place at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = from[k] + t * (to[k] - from[k]);
      disc(at, radius, color);
    }
  }

  /// Returns the pixels. Each is the mean of a square of `side` × `side` samples.
  std::vector<std::uint8_t> pixels(int side) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(depths_.size() * 3);
    for (int y = 0; y < height_; y += side)
      for (int x = 0; x < width_; x += side) {
        step_();
        unsigned red = 0, green = 0, blue = 0;
        for (int j = 0; j < side; ++j)
          for (int i = 0; i < side; ++i) {
            const Color& c = colors_[static_cast<std::size_t>(y + j) * static_cast<std::size_t>(width_) +
                                     static_cast<std::size_t>(x + i)];
            red += c.red;
            green += c.green;
            blue += c.blue;
          }
        const auto samples = static_cast<unsigned>(side * side);
        for (const unsigned sum : {red, green, blue})
          bytes.push_back(static_cast<std::uint8_t>((sum + samples / 2) / samples));
      }
    return bytes;
  }

 private:
  static int inside(double value, int size) { return static_cast<int>(std::clamp<double>(value, 0, size)); }

  int width_;
  int height_;
  std::vector<float> depths_;
  std::vector<Color> colors_;
  InterruptibleSteps step_;
};

/// Returns the color of a triangle under light from the upper left of the viewer. As y points down, a triangle that is
/// counter-clockwise for the viewer has a negative area.
Color shade(const Place& a, const Place& b, const Place& c, const Color& front_own) {
  const double u[] = {b[0] - a[0], a[1] - b[1], b[2] - a[2]}, v[] = {c[0] - a[0], a[1] - c[1], c[2] - a[2]};
  const double n[] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  const bool front = n[2] >= 0;
  const double toward = length > 0 ? (front ? 1 : -1) * (-0.4 * n[0] + 0.45 * n[1] + 0.8 * n[2]) / length : 1;
  const double light = 0.42 + 0.58 * std::clamp(toward, 0.0, 1.0);
  const Color& own = front ? front_own : back_color;
  const auto lit = [&](std::uint8_t part) { return static_cast<std::uint8_t>(std::lround(part * light)); };
  return {lit(own.red), lit(own.green), lit(own.blue)};
}

/// Returns the color of a triangle before shading: the color of filled holes if it fills a hole, otherwise the mean
/// color of its corners, or the default color if the points have no colors.
Color own_color(const SurfacePicture& picture, std::size_t triangle) {
  if (!picture.filled.empty() && picture.filled[triangle]) return filled_color;
  const auto& t = picture.triangles[triangle];
  if (picture.colors.empty()) return front_color;
  const auto mean = [&](std::size_t k) {
    return static_cast<std::uint8_t>((picture.colors[t[0]][k] + picture.colors[t[1]][k] + picture.colors[t[2]][k] + 1) /
                                     3);
  };
  return {mean(0), mean(1), mean(2)};
}

}  // namespace

void write_surface_png(OutputFile& file, const SurfacePicture& picture, int width) {
  const int side = width > 4096 ? 1 : 2;
  SpaceView view = view_of(picture.points, width);
  for (Place& at : view.at)
    for (double& x : at) x *= side;
  DepthCanvas canvas(view.width * side, view.height * side);
  InterruptibleSteps step;
  for (std::size_t i = 0; i < picture.triangles.size(); ++i) {
    step();
    const auto& t = picture.triangles[i];
    const Place &a = view.at[t[0]], &b = view.at[t[1]], &c = view.at[t[2]];
    canvas.triangle(a, b, c, shade(a, b, c, own_color(picture, i)));
  }
  // Raise lines by their thickness toward the viewer, so that a rim is visible along its whole length.
  const double radius = side * std::max(1.0, width / 700.0);
  const auto raised = [&](std::uint32_t i) { return Place{view.at[i][0], view.at[i][1], view.at[i][2] + 2 * radius}; };
  for (const std::uint32_t i : picture.unused) {
    step();
    canvas.disc(view.at[i], radius, boundary_color);
  }
  const auto draw = [&](std::span<const std::array<std::uint32_t, 2>> sides, const Color& color) {
    for (const auto& [from, to] : sides) {
      step();
      canvas.line(raised(from), raised(to), radius, color);
    }
  };
  draw(picture.rims, rim_color);
  draw(picture.islands, island_color);
  draw(picture.holes, isolated_color);
  write_png(file, view.width, view.height, canvas.pixels(side));
}

}  // namespace rbpa::app
