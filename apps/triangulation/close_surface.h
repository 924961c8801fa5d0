// What: holes of a surface filled, with what became of them and of the curves that stay.
// Law:  a function of the surface and the choice.
#pragma once

#include <span>
#include <vector>

#include "rbpa/curve_kinds.h"
#include "rbpa/holes.h"
#include "rbpa/surface.h"
#include "rbpa/surface_components.h"
#include "triangulation/filling_counts.h"
#include "triangulation/hole_choice.h"

namespace rbpa::app {

/// A surface with the curves at which it ends, and their kinds.
struct BoundedSurface {
  Surface surface;
  SurfaceComponents components;
  std::vector<Hole> curves;
  std::vector<CurveKind> kinds;
};

/// Fills the holes that are chosen. Curves that stay keep the causes of their edges.
/// Requires: an indexable surface, its components, and its curves as surface_curves() has them, possibly with causes.
/// Throws:   as fill_holes().
FillingCounts fill_chosen(std::span<const Point3> points, const HoleChoice& choice, BoundedSurface& bounded,
                          const SurfaceOptions& options);

/// Fills every curve. Where some stay open, gives up the triangles around these, then those around what still stays open, and so
/// on, a few times, and fills what is then open; likewise the triangles around points at which parts of the surface touch. The
/// surface keeps them where that does not help, where these are more than a twentieth of all triangles, where it would fall into
/// more components, and where a curve that stays has more than 256 edges.
/// Requires and throws as fill_chosen().
FillingCounts close_all(std::span<const Point3> points, BoundedSurface& bounded, const SurfaceOptions& options);

/// The curves of a surface, with the causes that some of its edges have in `known`.
std::vector<Hole> with_causes(std::vector<Hole> curves, std::span<const Hole> known);

}  // namespace rbpa::app
