#include "picture/scene.h"

#include <algorithm>
#include <cmath>

namespace rbpa::app {
namespace {

/// Scales points by a power of two to about 1, so that differences of coordinates neither overflow nor underflow.
struct Frame {
  int exponent = 0;
  Pixel least{0, 0};
  double width = 0;
  double height = 0;

  explicit Frame(std::span<const Point> points) {
    if (points.empty()) return;
    double largest = 0;
    for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    if (largest > 0) exponent = -std::ilogb(largest);
    least = scaled(points[0]);
    Pixel greatest = least;
    for (const Point& p : points) {
      const Pixel q = scaled(p);
      least = {std::min(least.x, q.x), std::min(least.y, q.y)};
      greatest = {std::max(greatest.x, q.x), std::max(greatest.y, q.y)};
    }
    width = greatest.x - least.x;
    height = greatest.y - least.y;
  }

  Pixel scaled(const Point& p) const { return {std::scalbn(p.x, exponent), std::scalbn(p.y, exponent)}; }
};

double length(const Pixel& a, const Pixel& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

/// Returns the median length of a sample of at most 20000 edges; 0 if there are no edges.
double typical_length(const Drawing& drawing, const std::vector<Pixel>& at) {
  constexpr std::size_t enough = 10000;
  std::vector<double> lengths;
  const auto add_some_of = [&](std::span<const Edge> edges) {
    for (std::size_t i = 0; i < edges.size(); i += edges.size() / enough + 1)
      lengths.push_back(length(at[edges[i][0]], at[edges[i][1]]));
  };
  add_some_of(drawing.inner_edges);
  if (lengths.empty())
    for (const std::vector<std::uint32_t>& curve : drawing.curves) {
      lengths.push_back(length(at[curve[0]], at[curve[1]]));
      if (lengths.size() == enough) break;
    }
  if (lengths.empty()) add_some_of(drawing.dangling);
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

Strokes strokes_for(const Drawing& drawing, const std::vector<Pixel>& at, double inner_width, double inner_height) {
  const double edge = typical_length(drawing, at);
  const double count = std::max<double>(1, static_cast<double>(drawing.points.size()));
  const double spacing = std::sqrt(inner_width * inner_height / count);
  return {.edge_width = std::clamp(0.11 * edge, 0.02, 0.9),
          .boundary_width = std::clamp(0.25 * edge, 0.75, 2.2),
          .dot_radius = std::clamp(0.3 * spacing, 0.8, 3.5)};
}

}  // namespace

Scene place(const Drawing& drawing, int width) {
  const double margin = 0.03 * width, inner_width = width - 2 * margin;
  constexpr double flattest = 0.125, tallest = 2;  // ratio of height to width of the inner part
  const Frame frame(drawing.points);

  // The box is a unit square if all points are equal. An infinite ratio is harmless, as it is clamped before use.
  const double ratio = frame.width > 0 ? frame.height / frame.width : (frame.height > 0 ? tallest + 1 : flattest);
  const double inner_height = std::round(inner_width * std::clamp(ratio, flattest, tallest));
  const bool by_width = ratio <= tallest;
  // Compute positions as fractions of the box first: the number of pixels for each unit may be out of range.
  const double box = by_width ? frame.width : frame.height;
  const double box_pixels = by_width ? inner_width : inner_height;
  const double used_width = by_width ? inner_width : inner_height / ratio;
  const double used_height = by_width ? inner_width * ratio : inner_height;
  const double left = margin + (inner_width - used_width) / 2;
  const double bottom = margin + (inner_height + used_height) / 2;

  Scene scene{.width = width,
              .height = static_cast<int>(std::round(inner_height + 2 * margin)),
              .at = {},
              .strokes = {},
              .drawing = &drawing,
              .pixel_size = std::scalbn(box / box_pixels, -frame.exponent),
              .corner = {std::scalbn(frame.least.x - left * (box / box_pixels), -frame.exponent),
                         std::scalbn(frame.least.y + bottom * (box / box_pixels), -frame.exponent)}};
  scene.at.reserve(drawing.points.size());
  const auto fraction = [&](double part) { return box > 0 ? part / box : 0.5; };
  for (const Point& p : drawing.points) {
    const Pixel q = frame.scaled(p);
    scene.at.push_back(
        {left + fraction(q.x - frame.least.x) * box_pixels, bottom - fraction(q.y - frame.least.y) * box_pixels});
  }
  scene.strokes = strokes_for(drawing, scene.at, inner_width, inner_height);
  return scene;
}

}  // namespace rbpa::app
