// What: writes the alpha complex of points in space as one HTML page: its boundary at every radius, which the reader
//       can turn; the persistence diagram; cycles and surfaces of its longest pairs.
// Law:  the bytes depend on SpaceReport alone. The page makes no network request.
// Source: docs/reference/file_formats.md has the format of the data in the page.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "io/bytes/output_file.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/persistence/solid_representatives.h"

namespace rbpa::app {

struct SpaceReport {
  std::string source;  ///< name of the input for people
  std::span<const Point3> points;
  const SolidFiltration& filtration;
  double cover;                            ///< share of the points that "min" and "auto" cover
  double least_covering, least_connected;  ///< the radii "min" and "auto"
  std::optional<double> plateau;           ///< radius of the best plateau; nullopt if there is no plateau
  std::span<const SolidPair> pairs;        ///< all pairs
  std::span<const SolidPair> shown;        ///< the pairs with representatives
  std::span<const SolidRepresentative> representatives;
};

/// Writes the page. Throws Cancelled after a signal, and as OutputFile::write() does.
void write_space_report(OutputFile& file, const SpaceReport& report);

}  // namespace rbpa::app
