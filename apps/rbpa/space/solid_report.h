// What: reports on a solid (`rbpa solid`) as text and JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "io/bytes/output_file.h"
#include "rbpa/space/balls/measure_solid.h"
#include "space/point_names.h"

namespace rbpa::app {

/// A measured solid, with counts of its points, and the settings and seconds of the run.
struct SolidFacts : MeasuredSolid {
  std::size_t points = 0, distinct = 0, isolated = 0;
  std::string alpha_rule = "given";
  unsigned threads = 1;
  ComplexKind walls = ComplexKind::solid;     ///< kind of the complex whose voids are counted
  std::optional<double> choose_seconds = {};  ///< nullopt if alpha was given
  double read_seconds = 0, build_seconds = 0, count_seconds = 0, write_seconds = 0;
};

/// Returns "12 tetrahedra, 2 solid components, 1 tunnel, 0 voids, volume 2.5, area 8". The counts of the full complex
/// and the measures of the union of balls follow if they were computed.
std::string text_of_solid(const SolidFacts& facts);

/// Write one JSON object: write_solid_stats() counts, seconds and memory; write_solid_json() counts, and every
/// component and void.
void write_solid_stats(OutputFile& file, const SolidFacts& facts);
void write_solid_json(OutputFile& file, const SolidFacts& facts, const PointNames& names);

}  // namespace rbpa::app
