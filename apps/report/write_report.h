// What: a filtration as one page of HTML that shows the complex at every radius.
// Law:  the bytes depend on Report alone. The page makes no request.
// Source: docs/report.md has the format of the data in the page.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/bytes/output_file.h"
#include "rbpa/filtration_arrays.h"
#include "report/radii.h"

namespace rbpa::app {

struct Report {
  std::string source;                                   ///< where the points come from, as people call it
  std::optional<std::string_view> unit = std::nullopt;  ///< of the coordinates, by its name, where there is one
  Radii radii = {};
  std::optional<Recommendation> recommended = std::nullopt;  ///< none where there is no triangle
  FiltrationArrays arrays = {};
};

/// Throws Cancelled after a signal.
void write_report(OutputFile& file, const Report& report);

}  // namespace rbpa::app
