// What: fills holes of a surface, and keeps track of the curves that stay.
// Law:  the result is a function of the surface and the choice.
#pragma once

#include <span>
#include <vector>

#include "rbpa/space/repair/refine_filling.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface.h"
#include "rbpa/space/surface/surface_components.h"
#include "triangulation/filling_counts.h"
#include "triangulation/hole_choice.h"

namespace rbpa::app {

/// A surface with its boundary curves and their kinds.
struct BoundedSurface {
  Surface surface;
  SurfaceComponents components;
  std::vector<Hole> curves;
  std::vector<CurveKind> kinds;
  std::vector<bool> filled = {};  ///< for each triangle whether it fills a hole; empty: none does
};

/// Fills the chosen holes. Curves that stay keep the causes of their edges.
/// Requires: an indexable surface, its components, and its curves as surface_curves() returns them, possibly with
/// causes.
/// Throws:   as fill_holes().
FillingCounts fill_chosen(std::span<const Point3> points, const HoleChoice& choice, BoundedSurface& bounded,
                          const SurfaceOptions& options);

/// Refines and smooths the fillings like the surface around them, as rbpa::refine_filling() does, and updates the
/// counts.
/// Throws: as refine_filling().
AddedPoints refine(std::span<const Point3> points, BoundedSurface& bounded, FillingCounts& counts,
                   const SurfaceOptions& options);

/// Counts refined fillings: the new triangles, their area, and the added points.
void count_refined(std::span<const Point3> points, const Surface& surface, const std::vector<bool>& is_new,
                   const AddedPoints& added, FillingCounts& counts);

/// Returns the curves with the causes that `known` has for their edges.
std::vector<Hole> with_causes(std::vector<Hole> curves, std::span<const Hole> known);

}  // namespace rbpa::app
