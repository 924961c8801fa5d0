// What: colours and line widths of our pictures.
// Why:  blue against orange and dark against light stay apart for every kind of colour vision, and in grey.
#pragma once

#include <cstdint>

namespace rbpa::app {

struct Colour {
  std::uint8_t red, green, blue;
};

constexpr Colour background_colour{0xFD, 0xFC, 0xFA};
constexpr Colour fill_colour{0xCF, 0xE3, 0xF1};
constexpr Colour edge_colour{0x4A, 0x86, 0xB4};
constexpr Colour boundary_colour{0x10, 0x33, 0x5C};
constexpr Colour isolated_colour{0xD5, 0x5E, 0x00};

/// Sizes in pixels. They shrink with the triangles, so that lines never hide what they bound.
struct Strokes {
  double edge_width;
  double boundary_width;
  double dot_radius;
};

}  // namespace rbpa::app
