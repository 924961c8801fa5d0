#include <png.h>

#include <cstring>
#include <new>

#include "io/cloud/images.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "io/png_errors.h"

namespace rbpa::app {
namespace {

constexpr std::size_t bytes_per_pixel = 8;  // red, green, blue, opacity of 16 bits each

/// Decodes a file in memory by libpng. Members return false after an error.
class PngDecoder : public PngErrors {
 public:
  explicit PngDecoder(std::string_view bytes) : left_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, errors(), fail, ignore);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;

  bool read_header() {
    return attempt(png_, [this] {
      png_set_read_fn(png_, this, read);
      png_set_user_limits(png_, PNG_UINT_31_MAX,
                          PNG_UINT_31_MAX);  // no limit: require_image_size() refuses large images
      png_read_info(png_, info_);
    });
  }
  /// Makes libpng convert every row to red, green, blue and opacity, of 16 bits each. Returns false after an error.
  bool begin_rows() {
    return attempt(png_, [this] {
      png_set_expand_16(png_);
      png_set_gray_to_rgb(png_);
      png_set_add_alpha(png_, 0xFFFF, PNG_FILLER_AFTER);
      png_start_read_image(png_);
    });
  }
  bool read_row(png_byte* row) {
    return attempt(png_, [this, row] { png_read_row(png_, row, nullptr); });
  }
  bool read_end() {
    return attempt(png_, [this] { png_read_end(png_, nullptr); });
  }

  png_uint_32 width() const { return png_get_image_width(png_, info_); }
  png_uint_32 height() const { return png_get_image_height(png_, info_); }
  bool interlaced() const { return png_get_interlace_type(png_, info_) == PNG_INTERLACE_ADAM7; }

 private:
  static void ignore(png_struct*, const char*) {}
  static void read(png_struct* png, png_byte* to, std::size_t size) {
    auto& self = *static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (size > self.left_.size()) png_error(png, "the file ends early");
    self.left_.copy(reinterpret_cast<char*>(to), size);
    self.left_.remove_prefix(size);
  }

  std::string_view left_;
  png_struct* png_ = nullptr;
  png_info* info_ = nullptr;
};

Shade shade_of_pixel(const png_byte* pixel, double threshold) {
  const auto channel = [&](std::size_t i) { return 256U * pixel[2 * i] + pixel[2 * i + 1]; };
  if (channel(3) < 0x8000U) return Shade::clear;
  const unsigned grey = 2126 * channel(0) + 7152 * channel(1) + 722 * channel(2);
  return shade_of(grey, 10000.0 * 65535.0, threshold);
}

/// Reads the pixels; returns false after an error. An interlaced image is a sequence of finer and finer images, each
/// with pixels that are not in the earlier ones.
bool read_pixels(PngDecoder& decoder, Shades& image, double threshold) {
  if (!decoder.begin_rows()) return false;
  std::vector<png_byte> row(bytes_per_pixel * image.width);
  const bool interlaced = decoder.interlaced();
  for (int pass = 0; pass < (interlaced ? PNG_INTERLACE_ADAM7_PASSES : 1); ++pass) {
    const auto of_pass = [&](int value, std::size_t whole) {
      return interlaced ? static_cast<std::size_t>(value) : whole;
    };
    const std::size_t left = of_pass(PNG_PASS_START_COL(pass), 0), column_step = of_pass(PNG_PASS_COL_OFFSET(pass), 1);
    const std::size_t top = of_pass(PNG_PASS_START_ROW(pass), 0), row_step = of_pass(PNG_PASS_ROW_OFFSET(pass), 1);
    for (std::size_t y = top; y < image.height && left < image.width; y += row_step) {
      stop_if_interrupted();
      if (!decoder.read_row(row.data())) return false;
      const png_byte* pixel = row.data();
      for (std::size_t x = left; x < image.width; x += column_step, pixel += bytes_per_pixel)
        image.pixels[image.width * y + x] = shade_of_pixel(pixel, threshold);
    }
  }
  return decoder.read_end();
}

/// Throws BadInput if rows are too long for libpng's buffers, or if the file is too small for its pixels, of at least
/// one bit, with the greatest compression, 1032 to 1.
void require_room(std::size_t file_size, const PngDecoder& decoder, const std::string& name) {
  constexpr std::size_t widest = 1000000, max_pixels_per_byte = std::size_t{8} * 1032;
  const std::size_t width = decoder.width(), height = decoder.height();
  if (width > widest) bad_input(name, "an image of " + counted(width, "column"), "at most " + std::to_string(widest));
  if (width * height / max_pixels_per_byte > file_size)
    bad_input(name, "a file of " + counted(file_size, "byte"),
              "at least " + std::to_string(width * height / max_pixels_per_byte) + " for " + std::to_string(width) +
                  " x " + std::to_string(height) + " pixels as the header says");
}

}  // namespace

std::vector<Point> read_png_points(std::string_view bytes, const std::string& name, const PixelRule& rule) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
  if (bytes.substr(0, signature.size()) != signature)
    bad_input(name, in_quotes(bytes.substr(0, signature.size())), "a PNG image, which begins with '\\x89PNG'");
  PngDecoder decoder(bytes);
  const auto refuse = [&] { bad_input(name, in_quotes(decoder.message()), "a whole PNG image"); };
  if (!decoder.read_header()) refuse();
  require_image_size(decoder.width(), decoder.height(), name);
  require_room(bytes.size(), decoder, name);
  Shades image{decoder.width(), decoder.height(),
               std::vector<Shade>(std::size_t{1} * decoder.width() * decoder.height())};
  if (!read_pixels(decoder, image, rule.threshold)) refuse();
  return foreground_points(image, rule.foreground);
}

}  // namespace rbpa::app
