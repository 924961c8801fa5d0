// What: holes of a surface filled, with what became of them and of the curves that stay.
// Law:  a function of the surface and the choice.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/curve_kinds.h"
#include "rbpa/holes.h"
#include "rbpa/surface.h"
#include "rbpa/surface_components.h"
#include "triangulation/filling_counts.h"
#include "triangulation/hole_choice.h"

namespace rbpa::app {

/// A surface with the curves at which it ends and their kinds.
struct BoundedSurface {
  Surface surface;
  SurfaceComponents components;
  std::vector<Hole> curves;
  std::vector<CurveKind> kinds;
  std::vector<bool> filled = {};  ///< of each triangle, whether it fills a hole; empty: none does
};

/// Fills the holes that are chosen. Curves that stay keep the causes of their edges.
/// Requires: an indexable surface, its components, and its curves as surface_curves() has them, possibly with causes.
/// Throws:   as fill_holes().
FillingCounts fill_chosen(std::span<const Point3> points, const HoleChoice& choice, BoundedSurface& bounded,
                          const SurfaceOptions& options);

/// The same of every curve, as rbpa::close_surface() does it.
FillingCounts close_all(std::span<const Point3> points, BoundedSurface& bounded, const SurfaceOptions& options);

/// Points inside fillings.
struct AddedPoints {
  std::vector<Point3> points;                         ///< their numbers go on where the points' end
  std::vector<std::array<std::uint32_t, 3>> between;  ///< of each the points between which it was put
};

/// Makes what is filled as fine and smooth as the rest, as rbpa::refine_filling() does it, and changes the counts
/// accordingly.
/// Throws: as refine_filling().
AddedPoints refine(std::span<const Point3> points, BoundedSurface& bounded, FillingCounts& counts,
                   const SurfaceOptions& options);

/// The curves of a surface, with the causes that some of its edges have in `known`.
std::vector<Hole> with_causes(std::vector<Hole> curves, std::span<const Hole> known);

}  // namespace rbpa::app
