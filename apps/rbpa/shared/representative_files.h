// What: writes representatives of persistence pairs: in the plane, holes as polygons; in space, cycles around tunnels
//       and surfaces around voids.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/crs.h"
#include "io/formats.h"
#include "rbpa/base/pair_choice.h"
#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"
#include "rbpa/plane/representatives.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/persistence/solid_representatives.h"
#include "shared/arguments.h"
#include "shared/verbs.h"

namespace rbpa::app {

struct RepresentativeRequest {
  Target target;
  PairChoice choice;
  std::optional<std::vector<double>> levels;  ///< radii; only pairs that exist at one of the radii are written
  std::optional<std::size_t> leaf_capacity;   ///< leaf capacity of hrbpa; only pairs that exist at the radius of one of
                                              ///< its levels are written
};

/// Parses the options. Returns nothing if no representatives are requested. Throws WrongUsage that names the option.
std::optional<RepresentativeRequest> parse_representatives(const RepresentativeArguments& arguments, bool in_space);

/// Writes GeoJSON. Each hole has two Features, Polygons with the properties "pair" (its number, from 1), "dimension",
/// "birth", "death" (null if the hole never ends), "when" ("birth" or "death"), "area" and "points" (the input indices
/// of the points on the rings). Each component that ends has one Feature, a LineString with these properties except
/// "when" and "area".
void write_representatives(OutputFile& file, std::span<const Point> points, const std::optional<Crs>& crs, bool degrees,
                           std::span<const Representative> representatives, std::span<const std::uint32_t> index);

struct SpaceRepresentatives {
  std::span<const Point3> points;
  const SolidFiltration& filtration;
  std::span<const SolidPair> pairs;
  std::span<const SolidRepresentative> of_pairs;
  std::span<const std::uint32_t> index;  ///< input index of each point; empty if point i has input index i
};

/// Writes OBJ, JSON or VTU. OBJ has a group component_1, tunnel_1, void_1 … for each pair with cells. A group has its
/// own vertices, and lines or triangles; triangles face outward from the void. JSON is a list of pairs with the input
/// indices of the points. VTU has lines and triangles with the number of their pair (from 1), its dimension, birth and
/// death. Requires: `format` is one of Use::cycles.
void write_representatives(OutputFile& file, Format format, const SpaceRepresentatives& all);

}  // namespace rbpa::app
