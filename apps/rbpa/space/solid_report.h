// What: reports on a solid (`rbpa solid`), also in a periodic box (--box), as text, JSON and a table.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/balls/measure_solid.h"
#include "rbpa/space/balls/periodic_topology.h"
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

struct PeriodicFacts {
  std::size_t points = 0, distinct = 0, isolated = 0;
  Point3 box = {};
  double alpha = 0;
  std::string alpha_rule = "given";
  unsigned threads = 1;
  ComplexKind walls = ComplexKind::full;          ///< kind of the complex whose topology is counted
  std::optional<PeriodicTopology> topology = {};  ///< nullopt if the topology is not counted
  double read_seconds = 0, build_seconds = 0, count_seconds = 0, write_seconds = 0;
};

/// Returns "1 closed void, 2 voids that percolate in 1 direction, 1 void that percolates in 3 directions" for the
/// numbers of voids of each dimension.
std::string text_of_voids(const std::array<std::size_t, 4>& count);

/// Returns "12 tetrahedra, 2 solid components, 1 closed void, 1 void that percolates in 3 directions, volume 2.5, area
/// 8 (voids of the full complex)".
/// Requires: facts.topology has a value.
std::string text_of_periodic(const PeriodicFacts& facts);

/// Write one JSON object: write_periodic_stats() counts, seconds and memory; write_periodic_json() counts, and every
/// component and void. Require: facts.topology has a value.
void write_periodic_stats(OutputFile& file, const PeriodicFacts& facts);
void write_periodic_json(OutputFile& file, const PeriodicFacts& facts, const PointNames& names);

/// Writes the voids, the largest first, as a JSON list or as a table with the columns number, volume_between_points,
/// volume_outside_balls (only for the full complex), area, dimension, tetrahedra and points.
/// Requires: facts.topology has a value.
void write_periodic_voids(OutputFile& file, Format format, const PointNames& names, const PeriodicFacts& facts);

}  // namespace rbpa::app
