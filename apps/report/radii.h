// What: the radii of points: the critical ones, those that --alpha accepts by name, and the one to recommend.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/filtration.h"
#include "rbpa/plateaus.h"

namespace rbpa::app {

struct Radii {
  std::size_t points = 0;                                ///< with repetitions
  std::size_t max_components = 1;                        ///< at "auto"
  double cover = 1;                                      ///< share of the points, of the next two
  std::optional<double> least_covering = std::nullopt;   ///< "min"
  std::optional<double> least_connected = std::nullopt;  ///< "auto"
  std::vector<Plateau> plateaus = {};                    ///< the best first
  Filtration filtration = {};
};

/// A named value of --alpha, its radius, and the reason for it, without a full stop.
struct Recommendation {
  std::string choice;
  double alpha;
  std::string why;
};

}  // namespace rbpa::app
