// What: a filtration as a picture: its counts against alpha, and births against deaths.
// Law:  the same set of points gives the same bytes. At most some elements per pixel, however many steps and pairs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/filtration.h"
#include "rbpa/persistence.h"
#include "rbpa/plateaus.h"
#include "rbpa/solid_persistence.h"

namespace rbpa::app {

struct PlotCurve {
  std::string name;
  const char* colour;                    ///< as SVG has it
  std::vector<std::size_t> counts = {};  ///< at each of FiltrationPlot::alpha and up to the next
};

struct PlotDimension {
  std::string name;
  const char* colour;
};

struct FiltrationPlot {
  std::vector<double> alpha;  ///< ascending
  std::vector<PlotCurve> curves;
  std::vector<PersistencePair> pairs = {};
  std::vector<PlotDimension> dimensions;                 ///< of the pairs, from 0 on
  std::optional<double> least_covering = std::nullopt;   ///< marked "min"
  std::optional<double> least_connected = std::nullopt;  ///< marked "auto"
  std::optional<Plateau> plateau = std::nullopt;         ///< a band, and its alpha marked "plateau"
};

/// Of points in the plane: counts of the steps, pairs of components and of holes.
FiltrationPlot plot_of(std::span<const FiltrationStep> steps, std::vector<PersistencePair> pairs);

/// Of points in space: Betti numbers by the pairs' births and deaths.
FiltrationPlot plot_of(std::span<const SolidPair> pairs);

/// A whole SVG file.
std::string svg_of(const FiltrationPlot& plot);

}  // namespace rbpa::app
