// What: points from a PNG image.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/points/foreground.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

/// Of an image of any kind: grey, colour or palette, 1 to 16 bits, interlaced or not. Values are taken as they stand in
/// the file, without gamma; the grey value of a colour is 0.2126 red + 0.7152 green + 0.0722 blue; a pixel less than half
/// opaque is clear. Throws BadInput naming the file, before the pixels are allocated when no file of this size can hold
/// as many as it claims; Cancelled.
std::vector<Point> read_png_points(std::string_view bytes, const std::string& name, const PixelRule& rule);

}  // namespace rbpa::app
