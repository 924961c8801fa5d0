// What: where pairs of a persistence are, as files: holes of the plane as polygons; cycles around tunnels and surfaces around voids in space.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cli/arguments.h"
#include "cli/verbs.h"
#include "io/bytes/output_file.h"
#include "io/crs.h"
#include "io/formats.h"
#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"
#include "rbpa/pair_choice.h"
#include "rbpa/representatives.h"
#include "rbpa/solid_filtration.h"
#include "rbpa/solid_persistence.h"
#include "rbpa/solid_representatives.h"

namespace rbpa::app {

struct RepresentativeRequest {
  Target target;
  PairChoice choice;
  /// Only what is at these radii, or at those of hrbpa with this capacity of leaves.
  std::optional<std::vector<double>> levels;
  std::optional<std::size_t> leaf_capacity;
};

/// Nothing where none are requested. Throws WrongUsage that names the option.
std::optional<RepresentativeRequest> parse_representatives(const RepresentativeArguments& arguments, bool in_space);

/// GeoJSON: of each hole two Features, Polygons with "pair", from 1, "dimension", "birth", "death", null where it is left, "when", which is "birth" or "death", "area" and
/// "points", the input indices of those on its rings; of each component that ends one, a LineString with the same but "when" and "area".
void write_representatives(OutputFile& file, std::span<const Point> points, const std::optional<Crs>& crs, bool degrees,
                           std::span<const Representative> representatives, std::span<const std::uint32_t> index);

struct SpaceRepresentatives {
  std::span<const Point3> points;
  const SolidFiltration& filtration;
  std::span<const SolidPair> pairs;
  std::span<const SolidRepresentative> of_pairs;
  std::span<const std::uint32_t> index;  ///< of each point in the input; none where that is its number
};

/// OBJ: a group component_1, tunnel_1 or void_1 … of each, with vertices of its own; lines, or triangles seen from around. JSON: a list, with indices of points. VTU:
/// lines and triangles with the number of the pair, from 1, its dimension, birth and death. Requires: one of cycle_formats.
void write_representatives(OutputFile& file, Format format, const SpaceRepresentatives& all);

}  // namespace rbpa::app
