// What: defines the colors and line widths of all pictures.
// Why:  blue against orange, and dark against light, differ for every kind of color vision, and in gray.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rbpa::app {

struct Color {
  std::uint8_t red, green, blue;
};

constexpr Color background_color{0xFD, 0xFC, 0xFA};
constexpr Color fill_color{0xCF, 0xE3, 0xF1};
constexpr Color edge_color{0x4A, 0x86, 0xB4};
constexpr Color boundary_color{0x10, 0x33, 0x5C};
constexpr Color isolated_color{0xD5, 0x5E, 0x00};

/// The colors of a group of polygons. Groups may overlap.
struct GroupColors {
  Color fill, boundary;
};
constexpr double group_opacity = 0.6;  ///< opacity of the fill of groups, from 0 to 1
constexpr std::size_t group_color_count = 24;

/// Returns the colors of group k. Colors repeat after group_color_count groups. The first eight hues differ for every
/// kind of color vision (Okabe and Ito); a lighter and a darker shade of each hue follow.
constexpr GroupColors group_colors(std::size_t k) {
  constexpr Color hues[] = {{0x00, 0x72, 0xB2}, {0xE6, 0x9F, 0x00}, {0x00, 0x9E, 0x73}, {0xCC, 0x79, 0xA7},
                            {0xD5, 0x5E, 0x00}, {0x56, 0xB4, 0xE9}, {0xB8, 0xAE, 0x00}, {0x77, 0x77, 0x77}};
  constexpr int shades[] = {60, 35, 85};  // percent of the hue; the rest is white
  const Color hue = hues[k % 8];
  const int shade = shades[k / 8 % 3];
  const auto lit = [shade](std::uint8_t value) { return static_cast<std::uint8_t>(255 - (255 - value) * shade / 100); };
  const auto dark = [](std::uint8_t value) { return static_cast<std::uint8_t>(value * 2 / 3); };
  return {{lit(hue.red), lit(hue.green), lit(hue.blue)}, {dark(hue.red), dark(hue.green), dark(hue.blue)}};
}

/// Line widths and the radius of dots, in pixels. Lines are thinner where edges are shorter, so that lines do not hide
/// the triangles.
struct Strokes {
  double edge_width;
  double boundary_width;
  double dot_radius;
};

}  // namespace rbpa::app
