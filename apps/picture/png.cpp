#include "picture/png.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "picture/coverage.h"

namespace rbpa::app {
namespace {

/// A picture: red, green and blue of each pixel, by rows.
class Canvas {
 public:
  explicit Canvas(const Scene& scene)
      : bytes_(3 * static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height)) {
    for (std::size_t i = 0; i < bytes_.size(); i += 3) {
      bytes_[i] = background_color.red;
      bytes_[i + 1] = background_color.green;
      bytes_[i + 2] = background_color.blue;
    }
  }
  void paint(const std::vector<float>& coverage, const Color& color, float opacity = 1) {
    stop_if_interrupted();
    for (std::size_t i = 0; i < coverage.size(); ++i) {
      if (coverage[i] <= 0) continue;
      const float share = opacity * std::min(coverage[i], 1.0F);  // outlines of groups may overlap
      mix(bytes_[3 * i], color.red, share);
      mix(bytes_[3 * i + 1], color.green, share);
      mix(bytes_[3 * i + 2], color.blue, share);
    }
  }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  static void mix(std::uint8_t& value, std::uint8_t color, float share) {
    const float mixed = static_cast<float>(value) * (1 - share) + static_cast<float>(color) * share;
    value = static_cast<std::uint8_t>(std::lround(mixed));
  }
  std::vector<std::uint8_t> bytes_;
};

/// Calls visit(from, to) for every piece of the curves.
template <typename Visit>
void for_each_boundary_piece(const Scene& scene, std::span<const std::vector<std::uint32_t>> curves, Visit&& visit) {
  std::size_t done = 0;
  for (const std::vector<std::uint32_t>& curve : curves)
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (++done % 4096 == 0) stop_if_interrupted();
      visit(scene.at[curve[i]], scene.at[curve[i + 1 == curve.size() ? 0 : i + 1]]);
    }
}
template <typename Visit>
void for_each_boundary_piece(const Scene& scene, Visit&& visit) {
  for_each_boundary_piece(scene, scene.drawing->curves, visit);
}

/// Draws the groups color by color: all groups of one color together, in the order of the colors.
void draw_groups(Canvas& canvas, const Scene& scene) {
  const std::vector<std::size_t>& begin = scene.drawing->groups;
  const std::size_t count = begin.size() - 1;
  for (std::size_t k = 0; k < std::min(count, group_color_count); ++k) {
    AreaCoverage solid(scene.width, scene.height);
    LineCoverage boundary(scene.width, scene.height);
    for (std::size_t g = k; g < count; g += group_color_count)
      for_each_boundary_piece(scene, std::span(scene.drawing->curves).subspan(begin[g], begin[g + 1] - begin[g]),
                              [&](const Pixel& a, const Pixel& b) {
                                solid.add_piece(a, b);
                                boundary.add_line(a, b, scene.strokes.boundary_width);
                              });
    canvas.paint(solid.take(), group_colors(k).fill, static_cast<float>(group_opacity));
    canvas.paint(boundary.values(), group_colors(k).boundary);
  }
}

void add_lines(LineCoverage& to, const Scene& scene, std::span<const Edge> edges, double width) {
  std::size_t done = 0;
  for (const Edge& edge : edges) {
    if (++done % 4096 == 0) stop_if_interrupted();
    to.add_line(scene.at[edge[0]], scene.at[edge[1]], width);
  }
}

Canvas draw(const Scene& scene) {
  Canvas canvas(scene);
  if (!scene.drawing->groups.empty()) {
    draw_groups(canvas, scene);
    return canvas;
  }
  AreaCoverage solid(scene.width, scene.height);
  for_each_boundary_piece(scene, [&](const Pixel& a, const Pixel& b) { solid.add_piece(a, b); });
  canvas.paint(solid.take(), fill_color);

  LineCoverage edges(scene.width, scene.height);
  add_lines(edges, scene, scene.drawing->inner_edges, scene.strokes.edge_width);
  canvas.paint(edges.values(), edge_color);

  LineCoverage boundary(scene.width, scene.height);
  for_each_boundary_piece(
      scene, [&](const Pixel& a, const Pixel& b) { boundary.add_line(a, b, scene.strokes.boundary_width); });
  add_lines(boundary, scene, scene.drawing->dangling, scene.strokes.boundary_width);
  canvas.paint(boundary.values(), boundary_color);

  LineCoverage isolated(scene.width, scene.height);
  std::size_t done = 0;
  for (const std::uint32_t point : scene.drawing->isolated) {
    if (++done % 4096 == 0) stop_if_interrupted();
    isolated.add_dot(scene.at[point], scene.strokes.dot_radius);
  }
  canvas.paint(isolated.values(), isolated_color);
  return canvas;
}

}  // namespace

void write_png(OutputFile& file, const Scene& scene) {
  write_png(file, scene.width, scene.height, draw(scene).bytes());
}

void write_png(OutputFile& file, int width, int height, const std::vector<std::uint8_t>& pixels) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<char> encoded(size);
  // Encode in memory: exceptions of the output file must not pass through libpng.
  if (png_image_write_to_memory(&image, encoded.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    throw Failure(file.name() + ": cannot encode the picture: " + image.message);
  file.write({encoded.data(), size});
}

}  // namespace rbpa::app
