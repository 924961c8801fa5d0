// What: points from an image in the portable grey map format of Netpbm.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/points/foreground.h"
#include "rbpa/base/point.h"

namespace rbpa::app {

/// The first image of the file, in text (P2) or in bytes (P5) of 8 or 16 bits; what follows it is left alone, as Netpbm
/// does. Throws BadInput naming the file, and of text the line, before anything is allocated when the file is too short
/// for the size it claims; Cancelled.
std::vector<Point> read_pgm_points(std::string_view bytes, const std::string& name, const PixelRule& rule);

/// A Claim: the bytes of all pixels, or as many numbers.
double claimed_pgm_size(std::string_view first, const std::string& name);

}  // namespace rbpa::app
