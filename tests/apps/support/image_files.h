// What: images as files of every kind, for the programs to read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace apps_test {

/// Gray values from 0 to 255 in rows from the top; without opacity all pixels are opaque.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> grey = {};
  std::vector<std::uint8_t> opacity = {};
};

enum class PngKind { grey, grey_with_opacity, color, color_with_opacity, palette };

/// Returns a PNG file. `depth` is in bits a channel, or bits an index for a palette. Kinds without opacity make black
/// the transparent color of the file if the picture has opacity. Requires: the depth can hold the values; for 1 bit 0
/// and 255.
std::string png(const Picture& picture, PngKind kind, int depth, bool interlaced = false);

/// Returns a PNG file that ends where its pixels would begin.
std::string png_header(std::uint32_t width, std::uint32_t height);

/// Returns a PGM file, P2 or P5, with 255 · `scale` for white.
std::string pgm(const Picture& picture, bool as_text, std::uint32_t scale = 1);

}  // namespace apps_test
