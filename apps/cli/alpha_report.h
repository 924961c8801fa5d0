// What: what `rbpa alpha` has found, as text, JSON and CSV.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/output_file.h"
#include "rbpa/filtration/filtration.h"
#include "rbpa/filtration/persistence.h"
#include "rbpa/filtration/plateaus.h"

namespace rbpa::app {

struct AlphaReport {
  std::size_t points = 0;
  std::size_t most_components = 1;
  double cover = 1;  ///< share of the points, of the next two
  Filtration filtration = {};
  std::optional<double> least_covering = std::nullopt;   ///< "min"
  std::optional<double> least_connected = std::nullopt;  ///< "auto"
  std::vector<Plateau> plateaus = {};                    ///< the best first
  std::optional<std::vector<PersistencePair>> pairs = std::nullopt;
};

/// A choice that --alpha takes, its radius, and why: the best plateau, or "auto" where none is long.
struct Recommendation {
  std::string choice;
  double alpha;
  std::string why;
};

/// Nothing where the points have no triangle, or plateaus were not asked for.
std::optional<Recommendation> recommended(const AlphaReport& report);

/// For people: the radii by name, and a table of the choices there are.
std::string for_people(const AlphaReport& report);

/// Everything. Absent is null; a number too large for double is "inf", as in --stats. Throws Cancelled after a signal, as
/// the next do.
void write_json(OutputFile& out, const AlphaReport& report);

/// A line for every pair where there are pairs, else for every radius.
void write_csv(OutputFile& out, const AlphaReport& report);

}  // namespace rbpa::app
