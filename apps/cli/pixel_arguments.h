// What: the options about points from images.
#pragma once

#include <optional>
#include <string>

#include "io/cloud/images.h"

namespace rbpa::app {

/// What the command line says, as text.
struct PixelArguments {
  std::optional<std::string> foreground;
  std::optional<std::string> threshold;
};

/// "dark" or "light"; a number > 0 and <= 1. Throws WrongUsage naming the value.
PixelRule parse_pixel_rule(const PixelArguments& arguments);

}  // namespace rbpa::app
