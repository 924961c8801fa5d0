// What: what `rbpa solid --box` knows of a solid that repeats, as text, JSON and a table.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "cli/point_names.h"
#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "rbpa/base/point3.h"
#include "rbpa/periodic_topology.h"

namespace rbpa::app {

struct PeriodicFacts {
  std::size_t points = 0, distinct = 0, isolated = 0;
  Point3 box = {};
  double alpha = 0;
  std::string alpha_rule = "given";
  unsigned threads = 1;
  VoidWalls walls = VoidWalls::full;              ///< of the complex whose topology it is
  std::optional<PeriodicTopology> topology = {};  ///< where it was counted
  double read_seconds = 0, build_seconds = 0, count_seconds = 0, write_seconds = 0;
};

/// "12 tetrahedra, 2 solid components, 1 closed void, 2 channels, volume 2.5, area 8 (voids of the full complex)".
/// Requires: a topology.
std::string text_of_periodic(const PeriodicFacts& facts);

/// One JSON object each; the second has every component and every void. Requires: a topology.
void write_periodic_stats(OutputFile& file, const PeriodicFacts& facts);
void write_periodic_json(OutputFile& file, const PeriodicFacts& facts, const PointNames& names);

/// A JSON list, or a table "number,volume_between_points,volume_outside_balls,area,dimension,tetrahedra,points" with a
/// line for each, the largest first; the volume outside of the balls is that of voids of the full complex. Requires: a
/// topology.
void write_periodic_voids(OutputFile& file, Format format, const PointNames& names, const PeriodicFacts& facts);

}  // namespace rbpa::app
