// What:   the triangulation of a rim that turns least over its worst edge, and of those the one of the least area.
// How:    dynamic programming over the parts of the rim behind each chord (Barequet and Sharir 1995) with the weight of Liepa
//         (2003): the greatest turn over any edge, those of the rim included, and then the area. How far a triangle turns over a
//         chord depends on the triangle behind it, for which the best of that part alone is taken, as Liepa does: the result
//         need not be the best of all.
// Law:    a function of the rim, and where it begins.
// Cost:   n³/6 triangles for up to 256 corners, most of which are dismissed by a comparison; beyond, about n times a thousand.
// Source: Liepa, Filling holes in meshes (2003); Zou, Ju, Carr, An algorithm for triangulating multiple 3D polygons (2013) for
//         candidates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/space/closing/chords.h"
#include "rbpa/space/closing/rim.h"

namespace rbpa::space {

/// Corners of a rim, ascending.
using RimTriangle = std::array<std::uint32_t, 3>;

/// Ordered as that of the best is the least.
struct FillingWeight {
  float turn = 0;
  double area = 0;  ///< of places
  friend auto operator<=>(const FillingWeight&, const FillingWeight&) = default;
};

struct RimFilling {
  std::vector<RimTriangle> triangles;  ///< two fewer than corners; counter-clockwise where the rim is
  FillingWeight weight;
};

/// Without triangles whose corners are on a line, and without forbidden chords and triangles, which are sorted. Nothing where
/// that leaves no triangulation. `candidates`: candidate_chords() of the rim.
/// Requires: at least three corners. Throws: Cancelled.
std::optional<RimFilling> least_triangulation(const Rim& rim, std::vector<Chord> candidates,
                                              std::span<const Chord> forbidden_chords,
                                              std::span<const RimTriangle> forbidden_triangles, meshops::Steps& step);

}  // namespace rbpa::space
