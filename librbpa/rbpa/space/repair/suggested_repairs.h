// What: suggests repairs for holes of a surface, each tested: normals to turn around, a larger ball, or a filling.
// How:  turns the normals that are in the way, where the causes of the hole name some; then rolls ever larger balls
//       over the rim and takes the least radius at which the triangles so found are exposed; then fills.
// Law:  a function of the points, their normals and the radii, not of any order or number of threads. The effect of a
//       suggested repair is proved for the whole surface by exact tests of the part around the hole.
// Cost: for each radius that is tried, a sort of the points; for each hole, about twenty times that of surface() of the
//       points near its rim; that of fill_holes() for the remaining holes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

enum class SuggestedRepairKind : std::uint8_t {
  none,  ///< nothing that was tried closes the hole
  /// Turns the normals at `points`, and no others: surface() of the same radii is then closed there, and has no
  /// boundary where it had none before. It may have other triangles at these points.
  turn_normals,
  /// Adds `radius` to the radii: surface() is then closed there. No edge of the hole is boundary, nor any edge of an
  /// added triangle next to it.
  larger_ball,
  filling,  ///< fill_holes() closes the hole
};

struct SuggestedRepair {
  SuggestedRepairKind kind = SuggestedRepairKind::none;
  double radius = 0;                       ///< of the larger ball
  std::vector<std::uint32_t> points = {};  ///< points whose normals are to be turned; ascending
  /// The outcome of fill_holes(), if nothing else closes the hole; absent if no indexed file can hold the curve as it
  /// is.
  std::optional<HoleOutcome> filled = std::nullopt;
  friend bool operator==(const SuggestedRepair&, const SuggestedRepair&) = default;
};

/// Returns a suggested repair for each of the given holes. Balls are at most fourteen times as large as the last
/// radius, and not larger than the hole. The radius is the least at which the ball rests on the triangles by which it
/// closes the hole, if only their circumradii decide that; otherwise it is at most a thousandth more. Balls that close
/// the hole may be missed at radii between one that fails and 1.25 times that radius.
/// Requires: the surface() of these points, normals and radii, and some of its holes().
/// Throws:   InvalidInput as surface(); ContractViolation; Cancelled.
RBPA_API std::vector<SuggestedRepair> suggested_repairs(std::span<const Point3> points, std::span<const Point3> normals,
                                                        std::span<const double> radii, const Surface& surface,
                                                        std::span<const Hole> holes,
                                                        const SurfaceOptions& options = {});

}  // namespace rbpa
