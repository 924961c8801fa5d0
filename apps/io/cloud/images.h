// What: reads the foreground pixels of an image as points: from PNG, and from the portable gray map (PGM) of Netpbm.
// Law:  without a choice of the foreground, the background is the shade of most pixels of the border, and all other
//       pixels are foreground; a transparent pixel is never foreground.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa::app {

enum class Foreground { dark, light };

/// The rule that decides by gray values which pixels are foreground.
struct PixelRule {
  std::optional<Foreground> foreground = std::nullopt;  ///< absent: all shades but that of the border
  double threshold = 0.5;                               ///< share of white, from 0 to 1, from which on a pixel is light
};

enum class Shade : std::uint8_t { clear, dark, light };

/// Returns the shade of a gray value from 0 to `white`.
inline Shade shade_of(double grey, double white, double threshold) {
  return grey >= threshold * white ? Shade::light : Shade::dark;
}

/// An image of three shades.
struct Shades {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<Shade> pixels = {};  ///< by rows: from the top, each from the left
};

/// Throws BadInput if a side is 0, or if there are more pixels than rbpa() accepts points.
void require_image_size(std::size_t width, std::size_t height, const std::string& name);

/// Returns the centers of the foreground pixels, (column + ½, height − row − ½), row by row from the top: y points up,
/// and the origin is the lower left corner of the image. If shades are equally frequent on the border, clear is
/// preferred to light, and light to dark, as the background. On a clear background all other pixels are foreground.
/// Throws Cancelled.
std::vector<Point> foreground_points(const Shades& image, const std::optional<Foreground>& foreground);

/// Reads the first image of a PGM file, in text (P2) or in binary (P5) of 8 or 16 bits; ignores what follows the image,
/// as Netpbm does. Throws BadInput that names the file, and the line of a text, before memory is allocated if the file
/// is too short for the size in its header; Cancelled.
std::vector<Point> read_pgm_points(std::string_view bytes, const std::string& name, const PixelRule& rule);

/// Reads a PNG image of any kind: gray, color or palette, 1 to 16 bits, interlaced or not. Uses the values as stored,
/// without gamma; the gray value of a color is 0.2126 red + 0.7152 green + 0.0722 blue; a pixel less than half opaque
/// is clear. Throws BadInput that names the file, before the pixels are allocated if no file of this size can hold as
/// many as the header claims; Cancelled.
std::vector<Point> read_png_points(std::string_view bytes, const std::string& name, const PixelRule& rule);

}  // namespace rbpa::app
