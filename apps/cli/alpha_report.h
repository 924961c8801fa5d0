// What: what `rbpa alpha` has found, as text, JSON and CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/persistence.h"
#include "report/radii.h"

namespace rbpa::app {

struct AlphaReport {
  const Radii& radii;
  std::optional<std::vector<PersistencePair>> pairs = std::nullopt;
};

/// Nothing where the points have no triangle, or plateaus were not requested.
std::optional<Recommendation> recommended(const Radii& radii);

/// Of --output. Throws WrongUsage unless the ending is .svg.
void require_plot(const std::string& path);

/// For people: the radii by name, and a table of the choices there are.
std::string for_people(const AlphaReport& report);

/// Everything. Absent is null; a number too large for double is "inf", as in --stats. Throws Cancelled after a signal, as
/// the next do.
void write_json(OutputFile& out, const AlphaReport& report);

/// A line for every pair where there are pairs, else for every radius.
void write_csv(OutputFile& out, const AlphaReport& report);

}  // namespace rbpa::app
