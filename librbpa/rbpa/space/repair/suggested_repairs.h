// What: suggests a tested repair for each hole of a surface: reversing normals, a larger ball, or a filling.
// How:  first tries to reverse the normals that the causes of a hole name; then to roll ever larger balls over the rim,
//       the smallest of which closes the hole; then to fill the hole.
// Law:  a function of the points, their normals and the radii, not of any order or number of threads. Exact tests of
//       the part around the hole prove the effect of a suggested repair for the whole surface.
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
  none,  ///< no repair that was tried closes the hole
  /// Reversing the normals at `points`, and no others. surface() of the same radii then closes the hole and has no new
  /// boundary; it may have other triangles at these points.
  turn_normals,
  /// Adding `radius` to the radii. surface() then closes the hole: no edge of the hole, or of an added triangle next to
  /// it, is boundary.
  larger_ball,
  filling,  ///< filling the hole by fill_holes()
};

/// A repair of a hole. Members that do not belong to the kind keep their defaults, except `filled`.
struct SuggestedRepair {
  SuggestedRepairKind kind = SuggestedRepairKind::none;
  double radius = 0;                       ///< radius of the larger ball, in units of the points
  std::vector<std::uint32_t> points = {};  ///< points whose normals are to be reversed, equal ones included; ascending
  /// The outcome of fill_holes(), if no other repair closes the hole; absent if indexable_surface() changes the curve.
  std::optional<HoleOutcome> filled = std::nullopt;
  friend bool operator==(const SuggestedRepair&, const SuggestedRepair&) = default;
};

/// Returns a suggested repair for each of `holes`. Larger balls have at most 14.6 times the last radius, and at most
/// the diagonal of the hole's bounding box or 1.25 times the last radius, whichever is more. The radius of a larger
/// ball is the least at which the ball rests on all triangles that close the hole, if only their circumradii decide;
/// otherwise it is at most a thousandth larger than a radius that fails. A ball that closes the hole may be missed if
/// its radius is between one that fails and 1.25 times that radius, or if more than 4096 points decide.
/// Requires: `surface` is the surface() of these points, normals and radii, and `holes` are some of its holes().
/// Throws:   InvalidInput as surface() throws it; ContractViolation when the holes are visibly of another surface;
///           Cancelled.
RBPA_API std::vector<SuggestedRepair> suggested_repairs(std::span<const Point3> points, std::span<const Point3> normals,
                                                        std::span<const double> radii, const Surface& surface,
                                                        std::span<const Hole> holes,
                                                        const SurfaceOptions& options = {});

}  // namespace rbpa
