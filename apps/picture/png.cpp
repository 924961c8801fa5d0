#include "picture/picture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/png_errors.h"
#include "picture/coverage.h"

namespace rbpa::app {
namespace {

/// A picture: red, green and blue of each pixel, by rows.
class Canvas {
 public:
  explicit Canvas(const Scene& scene)
      : bytes_(3 * static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height)) {
    for (std::size_t i = 0; i < bytes_.size(); i += 3) {
      step_();
      bytes_[i] = background_color.red;
      bytes_[i + 1] = background_color.green;
      bytes_[i + 2] = background_color.blue;
    }
  }
  void paint(const std::vector<float>& coverage, const Color& color, float opacity = 1) {
    for (std::size_t i = 0; i < coverage.size(); ++i) {
      step_();
      if (coverage[i] <= 0) continue;
      const float share = opacity * std::min(coverage[i], 1.0F);  // outlines of groups may overlap
      mix(bytes_[3 * i], color.red, share);
      mix(bytes_[3 * i + 1], color.green, share);
      mix(bytes_[3 * i + 2], color.blue, share);
    }
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  static void mix(std::uint8_t& value, std::uint8_t color, float share) {
    const float mixed = static_cast<float>(value) * (1 - share) + static_cast<float>(color) * share;
    value = static_cast<std::uint8_t>(std::lround(mixed));
  }
  std::vector<std::uint8_t> bytes_;
  InterruptibleSteps step_;
};

/// Calls visit(from, to) for each straight piece of the curves.
template <typename Visit>
void for_each_boundary_piece(const Scene& scene, std::span<const std::vector<std::uint32_t>> curves, Visit&& visit) {
  for (const std::vector<std::uint32_t>& curve : curves)
    for (std::size_t i = 0; i < curve.size(); ++i)
      visit(scene.at[curve[i]], scene.at[curve[i + 1 == curve.size() ? 0 : i + 1]]);
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
  for (const Edge& edge : edges) to.add_line(scene.at[edge[0]], scene.at[edge[1]], width);
}

std::vector<std::uint8_t> draw(const Scene& scene) {
  Canvas canvas(scene);
  if (!scene.drawing->groups.empty()) {
    draw_groups(canvas, scene);
    return canvas.take();
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
  for (const std::uint32_t point : scene.drawing->isolated) isolated.add_dot(scene.at[point], scene.strokes.dot_radius);
  canvas.paint(isolated.values(), isolated_color);
  return canvas.take();
}

/// Encodes rows in memory by libpng. Members return false after an error. No exception passes through libpng.
class PngEncoder : public PngErrors {
 public:
  PngEncoder() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, errors(), fail, nullptr)) {
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ != nullptr) return;
    png_destroy_write_struct(&png_, nullptr);
    throw std::bad_alloc();
  }
  ~PngEncoder() { png_destroy_write_struct(&png_, &info_); }
  PngEncoder(const PngEncoder&) = delete;
  PngEncoder& operator=(const PngEncoder&) = delete;

  bool begin(png_uint_32 width, png_uint_32 height) {
    return attempt(png_, [&] {
      png_set_write_fn(png_, this, keep, nullptr);
      png_set_IHDR(png_, info_, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
                   PNG_FILTER_TYPE_BASE);
      png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
      png_write_info(png_, info_);
    });
  }
  bool add_row(const png_byte* row) {
    return attempt(png_, [&] { png_write_row(png_, row); });
  }
  bool end() {
    return attempt(png_, [&] { png_write_end(png_, info_); });
  }

  std::string_view bytes() const { return bytes_; }

 private:
  static void keep(png_struct* png, png_byte* bytes, std::size_t size) {
    bool is_kept = true;
    try {
      static_cast<PngEncoder*>(png_get_io_ptr(png))->bytes_.append(reinterpret_cast<const char*>(bytes), size);
    } catch (const std::exception&) {
      is_kept = false;
    }
    if (!is_kept) png_error(png, "out of memory");
  }

  png_struct* png_;
  png_info* info_;
  std::string bytes_;
};

}  // namespace

void write_png(OutputFile& file, const Scene& scene) { write_png(file, scene.width, scene.height, draw(scene)); }

void write_png(OutputFile& file, int width, int height, const std::vector<std::uint8_t>& pixels) {
  const std::size_t row_size = 3 * static_cast<std::size_t>(width);
  PngEncoder encoder;
  bool is_encoded = encoder.begin(static_cast<png_uint_32>(width), static_cast<png_uint_32>(height));
  for (std::size_t at = 0; is_encoded && at < pixels.size(); at += row_size) {
    stop_if_interrupted();
    is_encoded = encoder.add_row(&pixels[at]);
  }
  if (!is_encoded || !encoder.end()) throw Failure(file.name() + ": cannot encode the picture: " + encoder.message());
  file.write(encoder.bytes());
}

}  // namespace rbpa::app
