// What: images as files of every kind, for the programs to read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace apps_test {

/// Grey values from 0 to 255 in rows from the top; the opacity of all is 255 where it is left out.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> grey = {};
  std::vector<std::uint8_t> opacity = {};
};

enum class PngKind { grey, grey_with_opacity, colour, colour_with_opacity, palette };

/// `depth` is of bits a channel, of an index for a palette. Requires values that it can hold: of 1 bit 0 and 255 only.
/// Kinds without opacity make black the transparent color of the file when the picture has some.
std::string png(const Picture& picture, PngKind kind, int depth, bool interlaced = false);

/// A PNG file that ends where its pixels would begin.
std::string png_header(std::uint32_t width, std::uint32_t height);

/// P2 or P5, with 255 · `scale` for white.
std::string pgm(const Picture& picture, bool as_text, std::uint32_t scale = 1);

}  // namespace apps_test
