// What: draws a filtration: its counts against alpha, and births against deaths of persistence pairs.
// Law:  a set of points always gives the same bytes. The number of bytes is bounded by the pixels, however many steps
//       and pairs there are.
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
  const char* color;                     ///< color in the syntax of SVG
  std::vector<std::size_t> counts = {};  ///< counts[i] holds from FiltrationPlot::alpha[i] to the next value
};

struct PlotDimension {
  std::string name;
  const char* color;
};

struct FiltrationPlot {
  std::vector<double> alpha;  ///< ascending
  std::vector<PlotCurve> curves;
  std::vector<PersistencePair> pairs = {};
  std::vector<PlotDimension> dimensions;                 ///< indexed by the dimension of a pair
  std::optional<double> least_covering = std::nullopt;   ///< marked "min"
  std::optional<double> least_connected = std::nullopt;  ///< marked "auto"
  std::optional<Plateau> plateau = std::nullopt;         ///< shown as a band, with its alpha marked "plateau"
};

/// Returns the plot for points in the plane: the counts of `steps` as curves, and `pairs` of components and holes. No
/// radius is marked.
FiltrationPlot plot_of(std::span<const FiltrationStep> steps, std::vector<PersistencePair> pairs);

/// Returns the plot for points in space: Betti numbers as curves, counted from the births and deaths of `pairs`, and
/// `pairs`. No radius is marked.
FiltrationPlot plot_of(std::span<const SolidPair> pairs);

/// Returns the plot as the content of an SVG file.
std::string svg_of(const FiltrationPlot& plot);

}  // namespace rbpa::app
