// What: writes a filtration as one HTML page that shows the complex at every radius.
// Law:  the bytes depend on Report alone. The page makes no network request.
// Source: docs/reference/file_formats.md has the format of the data in the page.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/bytes/output_file.h"
#include "rbpa/plane/filtration_arrays.h"
#include "report/radii.h"

namespace rbpa::app {

struct Report {
  std::string source;                                   ///< name of the input for people
  std::optional<std::string_view> unit = std::nullopt;  ///< name of the unit of the coordinates, if known
  const Radii& radii;
  std::optional<Recommendation> recommended = std::nullopt;  ///< nullopt if there is no triangle
  FiltrationArrays arrays = {};
};

/// Writes the page. Throws Cancelled after a signal, and as OutputFile::write() does.
void write_report(OutputFile& file, const Report& report);

}  // namespace rbpa::app
