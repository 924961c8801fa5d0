// What: defines the critical radii of points, the radii that --alpha knows by name, and the recommended radius.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/plane/filtration.h"
#include "rbpa/plane/plateaus.h"

namespace rbpa::app {

struct Radii {
  std::size_t points = 0;          ///< number of points, including duplicates
  std::size_t max_components = 1;  ///< the most solid components at the radius "auto"
  double cover = 1;                ///< share of the points that least_covering and least_connected cover
  std::optional<double> least_covering = std::nullopt;   ///< the radius "min"
  std::optional<double> least_connected = std::nullopt;  ///< the radius "auto"
  std::vector<Plateau> plateaus = {};                    ///< the best first
  Filtration filtration = {};
};

/// A named value of --alpha, its radius, and the reason to choose it, without a full stop.
struct Recommendation {
  std::string choice;
  double alpha;
  std::string why;
};

}  // namespace rbpa::app
