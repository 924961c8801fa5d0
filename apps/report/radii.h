// What: the radii of points: the critical ones, those with a name in --alpha, and the recommended one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/plane/filtration.h"
#include "rbpa/plane/plateaus.h"

namespace rbpa::app {

struct Radii {
  std::size_t points = 0;                                ///< number of points, duplicates included
  std::size_t max_components = 1;                        ///< the most solid components of "auto"
  double cover = 1;                                      ///< share of the points that the next two cover
  std::optional<double> least_covering = std::nullopt;   ///< "min"
  std::optional<double> least_connected = std::nullopt;  ///< "auto"
  std::vector<Plateau> plateaus = {};                    ///< the best first
  Filtration filtration = {};
};

/// A named value of --alpha, its radius, and the reason for it, without a full stop at the end.
struct Recommendation {
  std::string choice;
  double alpha;
  std::string why;
};

}  // namespace rbpa::app
