// What: for holes of a surface what closes them, each remedy as it was tried: normals turned around, a larger ball, or a filling.
// How:  turns the normals that are in the way, where causes name some; then rolls ever larger balls over the rim, and takes the
//       least radius at which the triangles so found are exposed; then fills.
// Law:  a function of the points, their normals and the radii; of no order and no number of threads. What a remedy promises
//       holds for the whole surface, by exact tests of the part around the hole.
// Cost: for each radius that is tried a sort of the points; for each hole, that of surface() of the points near its rim, some
//       twenty times; that of fill_holes() for what is left.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/fill_holes.h"
#include "rbpa/holes.h"
#include "rbpa/surface.h"

namespace rbpa {

enum class RemedyKind : std::uint8_t {
  none,  ///< nothing that was tried closes it
  /// surface() of the same radii is closed there when the normals at `points`, and no others, are turned around, and ends nowhere
  /// where it did not before. It may have other triangles at these points.
  turn_normals,
  /// surface() of the same radii and `radius` as one more is closed there: no edge of the hole, and none of a triangle that is
  /// added next to it, is boundary.
  larger_ball,
  filling,  ///< fill_holes() closes it
};

struct HoleRemedy {
  RemedyKind kind = RemedyKind::none;
  double radius = 0;                       ///< of a larger ball
  std::vector<std::uint32_t> points = {};  ///< where normals are to be turned; ascending
  /// What a filling makes of it, where nothing else closes it; nothing where no file of indices holds the curve as it is.
  std::optional<HoleOutcome> filled = std::nullopt;
  friend bool operator==(const HoleRemedy&, const HoleRemedy&) = default;
};

/// Of each of some holes. Balls are at most fourteen times as large as the last radius, and not larger than the hole. The radius is
/// the least at which the ball rests on the triangles by which it closes the hole, where only their circumradii decide that;
/// otherwise at most a thousandth more. Between 1.25 times a radius that fails and that radius, balls may close it that are not found.
/// Requires: the surface() of these points, normals and radii, and some of its holes().
/// Throws:   InvalidInput as surface(); ContractViolation; Cancelled.
RBPA_API std::vector<HoleRemedy> hole_remedies(std::span<const Point3> points, std::span<const Point3> normals,
                                               std::span<const double> radii, const Surface& surface,
                                               std::span<const Hole> holes, const SurfaceOptions& options = {});

}  // namespace rbpa
