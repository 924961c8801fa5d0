#include "support/image_files.h"

#include <png.h>
#include <zlib.h>

#include <stdexcept>

namespace apps_test {
namespace {

int type_of(PngKind kind) {
  constexpr int types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA,
                           PNG_COLOR_TYPE_PALETTE};
  return types[static_cast<int>(kind)];
}

/// Packs values of `depth` bits each, the first in the highest bits.
class Bits {
 public:
  explicit Bits(int depth) : depth_(static_cast<unsigned>(depth)) {}
  /// Adds a value from 0 to 255, scaled to the depth.
  void add_grey(unsigned value) { add(depth_ == 16 ? value * 257 : value >> (8 - depth_)); }
  void add(unsigned value) {
    for (unsigned i = depth_; i-- > 0;) {
      if (used_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() = static_cast<png_byte>(bytes_.back() | ((value >> i & 1U) << (7 - used_ % 8)));
      ++used_;
    }
  }
  std::vector<png_byte>& bytes() { return bytes_; }

 private:
  unsigned depth_;
  std::size_t used_ = 0;
  std::vector<png_byte> bytes_;
};

std::vector<png_byte> row_of(const Picture& picture, std::uint32_t y, PngKind kind, int depth) {
  Bits bits(depth);
  for (std::uint32_t x = 0; x < picture.width; ++x) {
    const std::size_t i = std::size_t{y} * picture.width + x;
    const unsigned grey = picture.grey[i], opacity = picture.opacity.empty() ? 255U : picture.opacity[i];
    if (kind == PngKind::palette) {
      bits.add(grey >> (8 - depth));
      continue;
    }
    const bool color = kind == PngKind::color || kind == PngKind::color_with_opacity;
    for (int channel = 0; channel < (color ? 3 : 1); ++channel) bits.add_grey(grey);
    if (kind == PngKind::grey_with_opacity || kind == PngKind::color_with_opacity) bits.add_grey(opacity);
  }
  return bits.bytes();
}

std::vector<png_color> palette_of(int depth) {
  const unsigned count = 1U << static_cast<unsigned>(depth);
  std::vector<png_color> colors;
  for (unsigned i = 0; i < count; ++i) {
    const auto value = static_cast<png_byte>(255 * i / (count - 1));
    colors.push_back({value, value, value});
  }
  return colors;
}

void append(png_struct* png, png_byte* data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}
[[noreturn]] void fail(png_struct*, const char* message) { throw std::runtime_error(message); }

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFFU);
  return bytes;
}

}  // namespace

std::string png(const Picture& picture, PngKind kind, int depth, bool interlaced) {
  std::string file;
  png_struct* writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_info* info = png_create_info_struct(writer);
  png_set_write_fn(writer, &file, append, nullptr);
  png_set_IHDR(writer, info, picture.width, picture.height, depth, type_of(kind),
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
  if (kind == PngKind::palette) {
    const auto colors = palette_of(depth);
    png_set_PLTE(writer, info, colors.data(), static_cast<int>(colors.size()));
  }
  const bool has_channel = kind == PngKind::grey_with_opacity || kind == PngKind::color_with_opacity;
  if (!picture.opacity.empty() && !has_channel) {
    const png_byte first_of_palette = 0;
    const png_color_16 black{};
    png_set_tRNS(writer, info, &first_of_palette, 1, &black);
  }
  std::vector<std::vector<png_byte>> rows;
  for (std::uint32_t y = 0; y < picture.height; ++y) rows.push_back(row_of(picture, y, kind, depth));
  std::vector<png_byte*> starts;
  for (auto& row : rows) starts.push_back(row.data());
  png_write_info(writer, info);
  png_write_image(writer, starts.data());
  png_write_end(writer, info);
  png_destroy_write_struct(&writer, &info);
  return file;
}

std::string png_header(std::uint32_t width, std::uint32_t height) {
  const std::string chunk = "IHDR" + big_endian(width) + big_endian(height) + std::string("\x01\0\0\0\0", 5);
  const auto check = crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), static_cast<uInt>(chunk.size()));
  return "\x89PNG\r\n\x1A\n" + big_endian(13) + chunk + big_endian(static_cast<std::uint32_t>(check)) +
         big_endian(100) + "IDAT";
}

std::string pgm(const Picture& picture, bool as_text, std::uint32_t scale) {
  std::string file = as_text ? "P2" : "P5";
  file += "\n# a picture\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n" +
          std::to_string(255 * scale) + "\n";
  for (std::size_t i = 0; i < picture.grey.size(); ++i) {
    const std::uint32_t value = picture.grey[i] * scale;
    if (as_text) {
      file += std::to_string(value) + ((i + 1) % picture.width == 0 ? "\n" : " ");
    } else {
      if (255 * scale > 255) file += static_cast<char>(value >> 8U);
      file += static_cast<char>(value & 0xFFU);
    }
  }
  return file;
}

}  // namespace apps_test
