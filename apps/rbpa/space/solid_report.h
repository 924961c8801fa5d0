// What: reports on a solid (`rbpa solid`) as text and JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/balls/union_of_balls.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_components.h"
#include "rbpa/space/solid/solid_topology.h"
#include "rbpa/space/solid/voids.h"
#include "space/point_names.h"

namespace rbpa::app {

struct SolidFacts {
  std::size_t points = 0, distinct = 0, isolated = 0;
  double alpha = 0;
  std::string alpha_rule = "given";
  unsigned threads = 1;
  SolidCounts counts = {};
  BoundaryMeasures measures = {};
  std::optional<BallUnion> balls = {};          ///< with --balls
  std::optional<FullCounts> full = {};          ///< of the full complex, if requested
  ComplexKind walls = ComplexKind::solid;       ///< kind of the complex whose voids are counted
  std::vector<SolidComponent> components = {};  ///< solid ones
  std::vector<SolidVoid> voids = {};
  std::optional<double> choose_seconds = {};  ///< absent: alpha was given
  double read_seconds = 0, build_seconds = 0, count_seconds = 0, write_seconds = 0;
};

/// Returns "12 tetrahedra, 2 solid components, 1 tunnel, 0 voids, volume 2.5".
std::string text_of_solid(const SolidFacts& facts);

/// Write one JSON object each; the second has every component and every void.
void write_solid_stats(OutputFile& file, const SolidFacts& facts);
void write_solid_json(OutputFile& file, const SolidFacts& facts, const PointNames& names);

}  // namespace rbpa::app
