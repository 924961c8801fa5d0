// What: writes the result of `rbpa alpha` as text, JSON and CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/plane/persistence.h"
#include "report/radii.h"

namespace rbpa::app {

struct AlphaReport {
  const Radii& radii;
  std::optional<std::vector<PersistencePair>> pairs = std::nullopt;
};

/// Returns the recommended choice, or nothing if the points have no triangle or plateaus were not computed.
std::optional<Recommendation> recommended(const Radii& radii);

/// Throws WrongUsage unless `path`, the value of --output, ends in .svg.
void require_plot(const std::string& path);

/// Returns the report for people: the radii by name, and a table of the choices.
std::string for_people(const AlphaReport& report);

/// Writes the whole report as JSON. Missing values are null; infinite numbers are "inf", as in --stats. Throws
/// Cancelled after a signal.
void write_json(OutputFile& out, const AlphaReport& report);

/// Writes CSV: a line for each pair if the report has pairs, else for each radius. Throws Cancelled after a signal.
void write_csv(OutputFile& out, const AlphaReport& report);

}  // namespace rbpa::app
