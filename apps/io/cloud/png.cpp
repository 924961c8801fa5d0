#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <new>
#include <span>

#include "io/cloud/images.h"
#include "io/failure.h"
#include "io/interrupt.h"

namespace rbpa::app {
namespace {

constexpr std::size_t bytes_per_pixel = 8;  // red, green, blue, opacity of 16 bits each

/// libpng on a file in memory. It reports an error by a jump, which must not pass over a destructor: each step below
/// holds none, and returns false when libpng jumped.
class PngDecoder {
 public:
  explicit PngDecoder(std::string_view bytes) : left_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
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
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, read);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // our limits have messages of their own
    png_read_info(png_, info_);
    return true;
  }
  /// From here on every row is red, green, blue, opacity of 16 bits, whatever the file has.
  bool begin_rows() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_expand_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xFFFF, PNG_FILLER_AFTER);
    png_start_read_image(png_);
    return true;
  }
  bool read_row(png_byte* row) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_row(png_, row, nullptr);
    return true;
  }
  bool read_end() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_end(png_, nullptr);
    return true;
  }

  png_uint_32 width() const { return png_get_image_width(png_, info_); }
  png_uint_32 height() const { return png_get_image_height(png_, info_); }
  bool interlaced() const { return png_get_interlace_type(png_, info_) == PNG_INTERLACE_ADAM7; }
  /// Why the last step failed.
  const char* message() const { return message_.data(); }

 private:
  static void fail(png_struct* png, const char* message) {
    auto& self = *static_cast<PngDecoder*>(png_get_error_ptr(png));
    std::snprintf(self.message_.data(), self.message_.size(), "%s", message);
    png_longjmp(png, 1);
  }
  static void ignore(png_struct*, const char*) {}
  static void read(png_struct* png, png_byte* to, std::size_t size) {
    auto& self = *static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (size > self.left_.size()) png_error(png, "the file ends early");
    std::memcpy(to, self.left_.data(), size);
    self.left_.remove_prefix(size);
  }

  std::string_view left_;
  png_struct* png_ = nullptr;
  png_info* info_ = nullptr;
  std::array<char, 128> message_{};
};

Shade shade_of_pixel(const png_byte* pixel, double threshold) {
  const auto channel = [&](std::size_t i) { return 256U * pixel[2 * i] + pixel[2 * i + 1]; };
  if (channel(3) < 0x8000U) return Shade::clear;
  const unsigned grey = 2126 * channel(0) + 7152 * channel(1) + 722 * channel(2);
  return shade_of(grey, 10000.0 * 65535.0, threshold);
}

/// Every `step`-th pixel of a row or of a column, from `first` on.
struct Steps {
  std::size_t first, step;
  std::size_t count(std::size_t size) const { return size <= first ? 0 : (size - first - 1) / step + 1; }
};

/// A part of an image whose rows follow one another in the file.
struct Pass {
  Steps columns, rows;
};

/// An interlaced image is a sequence of ever finer ones, each of which has the pixels that those before it left out.
std::span<const Pass> passes_of(bool interlaced) {
  static constexpr Pass whole[] = {{{0, 1}, {0, 1}}};
  static constexpr Pass adam7[] = {{{0, 8}, {0, 8}}, {{4, 8}, {0, 8}}, {{0, 4}, {4, 8}}, {{2, 4}, {0, 4}},
                                   {{0, 2}, {2, 4}}, {{1, 2}, {0, 2}}, {{0, 1}, {1, 2}}};
  return interlaced ? std::span<const Pass>(adam7) : std::span<const Pass>(whole);
}

/// Fills in the pixels, or returns false.
bool read_pixels(PngDecoder& decoder, Shades& image, double threshold) {
  if (!decoder.begin_rows()) return false;
  std::vector<png_byte> row(bytes_per_pixel * image.width);
  for (const auto& [columns, rows] : passes_of(decoder.interlaced())) {
    const std::size_t width = columns.count(image.width), height = width == 0 ? 0 : rows.count(image.height);
    for (std::size_t y = 0; y < height; ++y) {
      stop_if_interrupted();
      if (!decoder.read_row(row.data())) return false;
      Shade* to = &image.pixels[image.width * (rows.first + y * rows.step)];
      for (std::size_t x = 0; x < width; ++x)
        to[columns.first + x * columns.step] = shade_of_pixel(&row[bytes_per_pixel * x], threshold);
    }
  }
  return decoder.read_end();
}

/// Throws BadInput when rows are too long to be held in memory in every form they pass through, or the file is too small.
/// Its rows are compressed, at best 1032 to 1, from at least a bit a pixel.
void require_room(std::size_t file_size, const PngDecoder& decoder, const std::string& name) {
  constexpr std::size_t widest = 1000000, max_pixels_per_byte = std::size_t{8} * 1032;
  const std::size_t width = decoder.width(), height = decoder.height();
  if (width > widest)
    bad_input(name, "rows of " + std::to_string(width) + " pixels", "at most " + std::to_string(widest));
  if (width * height / max_pixels_per_byte > file_size)
    bad_input(name, counted(file_size, "byte"),
              "at least " + std::to_string(width * height / max_pixels_per_byte) + " for " + std::to_string(width) +
                  " x " + std::to_string(height) + " pixels as the header says");
}

}  // namespace

std::vector<Point> read_png_points(std::string_view bytes, const std::string& name, const PixelRule& rule) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
  if (bytes.substr(0, signature.size()) != signature) bad_input(name, "no PNG signature", "a PNG image");
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
