// What: the figure of an image as points: PNG, and the portable gray map of Netpbm.
// Law:  the foreground is what the ground is not, and the ground is what most pixels of the border are; a transparent
//       pixel is never foreground.
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

/// How gray values become a figure.
struct PixelRule {
  std::optional<Foreground> foreground = std::nullopt;  ///< none: the one that the border is not
  double threshold = 0.5;                               ///< share of white from which on a pixel is light
};

enum class Shade : std::uint8_t { clear, dark, light };

/// A pixel by its gray value, which is at most `white`.
inline Shade shade_of(double grey, double white, double threshold) {
  return grey >= threshold * white ? Shade::light : Shade::dark;
}

/// An image of three values.
struct Shades {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<Shade> pixels = {};  ///< rows from the top, each from the left
};

/// Throws BadInput when a side is zero, or when there are as many pixels as rbpa() refuses as points.
void require_image_size(std::size_t width, std::size_t height, const std::string& name);

/// The centers of the foreground pixels, (column + ½, height − row − ½), row by row from the top: y goes up, and the
/// origin is the lower left corner of the image. Of equally many pixels on the border, clear comes before light and light
/// before dark as the ground; on a clear ground all other pixels are foreground. Throws Cancelled.
std::vector<Point> foreground_points(const Shades& image, const std::optional<Foreground>& foreground);

/// The first image of the file, in text (P2) or in bytes (P5) of 8 or 16 bits; what follows it is left alone, as Netpbm
/// does. Throws BadInput naming the file, and of text the line, before anything is allocated when the file is too short
/// for the size it claims; Cancelled.
std::vector<Point> read_pgm_points(std::string_view bytes, const std::string& name, const PixelRule& rule);

/// A Claim: the bytes of all pixels, or as many numbers.
double claimed_pgm_size(std::string_view first, const std::string& name);

/// Of an image of any kind: gray, color or palette, 1 to 16 bits, interlaced or not. Values are taken as they stand in
/// the file, without gamma; the gray value of a color is 0.2126 red + 0.7152 green + 0.0722 blue; a pixel less than half
/// opaque is clear. Throws BadInput naming the file, before the pixels are allocated when no file of this size can hold
/// as many as it claims; Cancelled.
std::vector<Point> read_png_points(std::string_view bytes, const std::string& name, const PixelRule& rule);

}  // namespace rbpa::app
