// What: a filtration as one page of HTML that shows the complex at every radius.
// Law:  the bytes depend on what is in Report alone. The page asks for nothing from anywhere.
// Source: docs/report.md says how the data lie in the page.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/output_file.h"
#include "rbpa/filtration/filtration.h"
#include "rbpa/filtration/filtration_arrays.h"
#include "rbpa/filtration/plateaus.h"

namespace rbpa::app {

struct Report {
  /// A choice that --alpha takes, its radius, and a sentence without its full stop.
  struct Recommended {
    std::string choice;
    double alpha;
    std::string why;
  };

  std::string source;                                     ///< where the points come from, as people call it
  std::size_t points = 0;                                 ///< with repetitions
  std::size_t most_components = 1;                        ///< at "auto"
  double cover = 1;                                       ///< share of the points, of the next two
  std::optional<double> least_covering = std::nullopt;    ///< "min"
  std::optional<double> least_connected = std::nullopt;   ///< "auto"
  std::vector<Plateau> plateaus = {};                     ///< the best first
  std::optional<Recommended> recommended = std::nullopt;  ///< none where there is no triangle
  Filtration filtration = {};
  FiltrationArrays arrays = {};
};

/// Throws Cancelled after a signal.
void write_report(OutputFile& file, const Report& report);

}  // namespace rbpa::app
