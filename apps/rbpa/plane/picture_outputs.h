// What: adds a picture to the output files of a run, and a world file by which GIS programs place it on a map.
#pragma once

#include <optional>

#include "io/crs.h"
#include "picture/drawing.h"
#include "shared/run.h"

namespace rbpa::app {

/// Adds the picture. If the coordinates have the system `crs` and the target is a file .png, adds a world file, .pgw,
/// with the size of a pixel and the center of the upper left pixel; otherwise prints a warning, unless quiet, about a
/// world file that is there. Requires: is_picture(target.format);
/// least_width ≤ width ≤ greatest_width. Throws as Run::add() and write_picture() do.
void add_picture(Run& run, const Target& target, const Drawing& drawing, int width, const std::optional<Crs>& crs);

}  // namespace rbpa::app
