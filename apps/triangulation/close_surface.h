// What: holes of a surface filled, with what became of them and of the curves that stay.
// Law:  a function of the surface and the choice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/curve_kinds.h"
#include "rbpa/fill_holes.h"
#include "rbpa/holes.h"
#include "rbpa/surface.h"
#include "rbpa/surface_components.h"
#include "triangulation/hole_choice.h"

namespace rbpa::app {

/// How many holes were filled, and how many stay open for which reason, by HoleOutcome.
struct FillingCounts {
  std::array<std::size_t, 4> holes = {};
  std::size_t triangles = 0;  ///< new
  double area = 0;            ///< theirs
  std::size_t given_up = 0;   ///< triangles around holes, so that these can be filled

  std::size_t filled() const { return holes[static_cast<std::size_t>(HoleOutcome::filled)]; }
  std::size_t left() const { return holes[1] + holes[2] + holes[3]; }
};

/// A surface with the curves at which it ends, and their kinds.
struct BoundedSurface {
  Surface surface;
  SurfaceComponents components;
  std::vector<Hole> curves;
  std::vector<CurveKind> kinds;
};

/// Fills the holes that are chosen: of kind `hole`, or with `rims` every curve. Curves that stay keep the causes of their edges.
/// Requires: an indexable surface, its components, and its curves as surface_curves() has them, possibly with causes.
/// Throws:   as fill_holes().
FillingCounts fill_chosen(std::span<const Point3> points, const HoleChoice& choice, bool rims, BoundedSurface& bounded,
                          const SurfaceOptions& options);

/// Fills every curve. Where some stay open, gives up the triangles around these, then those around what still stays open, and so
/// on, a few times, and fills what is then open. The surface keeps them where that does not help, where these are more than a
/// twentieth of all triangles, where it would fall into more components, and where a curve that stays has more than 256 edges.
/// Requires and throws as fill_chosen().
FillingCounts close_all(std::span<const Point3> points, BoundedSurface& bounded, const SurfaceOptions& options);

/// The curves of a surface, with the causes that some of its edges have in `known`.
std::vector<Hole> with_causes(std::vector<Hole> curves, std::span<const Hole> known);

}  // namespace rbpa::app
