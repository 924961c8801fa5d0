// What: draws a filtration: its counts against alpha, and births against deaths.
// Law:  the same set of points gives the same bytes. The size is bounded by that of the picture, not by steps or pairs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/plane/filtration.h"
#include "rbpa/plane/persistence.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/space/persistence/solid_persistence.h"

namespace rbpa::app {

struct PlotCurve {
  std::string name;
  const char* color;                     ///< in the syntax of SVG
  std::vector<std::size_t> counts = {};  ///< from each value of FiltrationPlot::alpha up to the next
};

struct PlotDimension {
  std::string name;
  const char* color;
};

struct FiltrationPlot {
  std::vector<double> alpha;  ///< ascending
  std::vector<PlotCurve> curves;
  std::vector<PersistencePair> pairs = {};
  std::vector<PlotDimension> dimensions;                 ///< names of the dimensions of pairs, from 0
  std::optional<double> least_covering = std::nullopt;   ///< marked "min"
  std::optional<double> least_connected = std::nullopt;  ///< marked "auto"
  std::optional<Plateau> plateau = std::nullopt;         ///< shown as a band, with its alpha marked "plateau"
};

/// Returns the plot for points in the plane: the counts of the steps, and pairs of components and of holes.
FiltrationPlot plot_of(std::span<const FiltrationStep> steps, std::vector<PersistencePair> pairs);

/// Returns the plot for points in space: Betti numbers, counted from the births and deaths of pairs.
FiltrationPlot plot_of(std::span<const SolidPair> pairs);

/// Returns the plot as an SVG file.
std::string svg_of(const FiltrationPlot& plot);

}  // namespace rbpa::app
