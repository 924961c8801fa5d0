// What: a filtration as a picture: its counts against alpha, and births against deaths.
// Law:  the same set of points gives the same bytes. At most some elements per pixel, however many steps and pairs.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "rbpa/filtration.h"
#include "rbpa/persistence.h"
#include "rbpa/plateaus.h"

namespace rbpa::app {

struct FiltrationPlot {
  std::span<const FiltrationStep> steps;
  std::span<const PersistencePair> pairs;
  std::optional<double> least_covering;           ///< marked "min"
  std::optional<double> least_connected;          ///< marked "auto"
  std::optional<Plateau> plateau = std::nullopt;  ///< a band, and its alpha marked "plateau"
};

/// A whole SVG file.
std::string svg_of(const FiltrationPlot& plot);

}  // namespace rbpa::app
