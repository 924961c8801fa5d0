// What:   finds the triangulation of a rim with the least turn over its worst edge; among several, that of least area.
// How:    dynamic programming over the parts of the rim behind each chord (Barequet and Sharir 1995) with the weight of
//         Liepa (2003): the greatest turn over any edge, edges of the rim included, then the area. The turn over a
//         chord depends on the triangle behind the chord. Only the best triangulation of each part is kept, as Liepa
//         does, so the result need not be the global optimum.
// Law:    a function of the rim and of the corner at which it begins.
// Cost:   n³/6 triangles up to 256 corners, most of them dismissed by one comparison; about 1000 n beyond.
// Source: Liepa, Filling holes in meshes (2003); Zou, Ju, Carr, An algorithm for triangulating multiple 3D polygons
//         (2013) for candidates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/space/repair/closing/chords.h"

namespace rbpa::space {

/// A triangle of three corners of a rim, by ascending positions.
using RimTriangle = std::array<std::uint32_t, 3>;

/// The quality of a filling; less is better.
struct FillingWeight {
  float turn = 0;   ///< the greatest turn_between() at an edge
  double area = 0;  ///< in squared units of Rim::places
  friend auto operator<=>(const FillingWeight&, const FillingWeight&) = default;
};

struct RimFilling {
  std::vector<RimTriangle> triangles;  ///< two fewer than corners, in the orientation of the rim
  FillingWeight weight;
};

/// Returns a triangulation without degenerate triangles (corners on a line), and without the forbidden chords and
/// triangles; nothing if there is none.
/// Requires: at least three corners; `candidates` are candidate_chords(rim); forbidden chords and triangles are sorted.
/// Throws:   Cancelled.
std::optional<RimFilling> least_triangulation(const Rim& rim, std::vector<Chord> candidates,
                                              std::span<const Chord> forbidden_chords,
                                              std::span<const RimTriangle> forbidden_triangles, meshops::Steps& step);

}  // namespace rbpa::space
