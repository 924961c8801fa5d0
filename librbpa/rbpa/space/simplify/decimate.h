// What:   decimates a surface: collapses edges, the least quadric error first, until few triangles are left; see
//         decimate_mesh.h for halfedge meshes.
// Law:    components, genus, orientation and Betti numbers stay, each boundary curve stays one curve, and closed
//         components stay closed. No triangle turns by a right angle or more in one collapse, and on request none
//         begins to cross another one. All decisions on this are exact; errors are rounded. A function of the points
//         and the surface.
// How:    where at most one of 32 triangles is to be left, the last collapses are repeated with other weights, up to
//         four times, and the nearest result stays (docs/explanation/surfaces.md, section 24).
// Cost:   n log n for n triangles; microseconds for each collapse.
// Source: Garland and Heckbert, Surface simplification using quadric error metrics (1997); Lawson (1961).
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

struct DecimationOptions {
  std::size_t faces = 0;  ///< the run ends as soon as at most this many triangles are left
  /// The run also ends as soon as at most this share of the triangles, rounded down, is left.
  std::optional<double> share = {};
  /// Limit of the distance from the triangles of the beginning. An edge collapses only if every point of the changed
  /// triangles is certified to be within the limit. If absent, there is no limit.
  std::optional<double> error = {};
  bool measured = false;      ///< bounds the distance from the triangles of the beginning; implied by `error`
  bool no_crossings = false;  ///< as QuadricOptions::no_crossings
  GoOn go_on = {};            ///< progress; false ends the run with Cancelled
};

/// Counts of a run.
struct Decimation {
  std::size_t given = 0;      ///< number of triangles before
  std::size_t left = 0;       ///< number of triangles after
  std::size_t collapses = 0;  ///< number of collapsed edges
  bool is_exhausted = false;  ///< whether the run ended because no edge was left that could collapse
  /// The number of refused collapses by reason: the names of meshops::BlockerKind if the topology would change, and the
  /// keys `turned`, `crossing` and `too_far`. An edge may be refused several times, as it is tried again after a change
  /// near it.
  std::map<std::string, std::size_t> refused = {};

  /// A distance from the triangles of the beginning that no point of the result exceeds, rounding included. It is at
  /// most 1.05 times the greatest distance, with rare exceptions. Present if options.measured or options.error is set.
  std::optional<double> distance = {};

  /// Keys in `refused`: a triangle would turn by a right angle or more or lose its area; a triangle would cross another
  /// one; a triangle is not certified to be within `error`.
  static constexpr const char* turned = "turned triangle";
  static constexpr const char* crossing = "crossing triangles";
  static constexpr const char* too_far = "too far";
};

/// The result of decimate() for a surface, with the duplicates of the given surface.
struct DecimatedSurface : Surface {
  std::vector<std::uint32_t> given;  ///< for each triangle, its number among the triangles of the given surface
  Decimation counts;
};

/// Decimates a surface. Corners are points of the given surface: the end with the lesser error of each collapsed edge
/// stays where it is. Triangles keep their levels.
/// Requires: `surface` is a surface of `points`; its corners are finite; options.error, if present, is not NaN;
///           options.share, if present, is from 0 to 1.
/// Throws:   what surface_mesh() throws; InvalidInput when a corner is not finite; ContractViolation when the error is
///           NaN or the share out of range; Cancelled.
RBPA_API DecimatedSurface decimate(std::span<const Point3> points, const Surface& surface,
                                   const DecimationOptions& options);

}  // namespace rbpa
