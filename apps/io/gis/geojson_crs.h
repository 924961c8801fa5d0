// What: what GeoJSON says of its system of coordinates, and what is to be said about that.
#pragma once

#include <optional>
#include <string>

#include "io/gis/shape.h"

namespace rbpa::app {

/// The member "crs" and a comma, as the draft of 2008 has it; "" for WGS 84, which GeoJSON means by itself, and where
/// nothing is known.
std::string crs_member(const std::optional<Crs>& crs);

/// Why readers may take the coordinates for something else, if they may.
std::optional<std::string> geojson_caution(const Shape& shape);

}  // namespace rbpa::app
