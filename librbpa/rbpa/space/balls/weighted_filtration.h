// What:   computes the dual complex of balls at every growth: all simplices of the regular triangulation, and the power
//         at which each appears.
// Law:    at power p, a ball of radius R has the squared radius R² + p. For every double p, a simplex is in the dual
//         complex of the grown balls exactly if its power is at most p: the exact power is rounded up, by less than one
//         unit in the last place. No face of a simplex has a greater power than the simplex. A function of the set of
//         balls, and of their numbering. With radii 0, signed roots are the radii of solid_filtration().
// Cost:   that of regular_triangulation(), and two to three times as much again; threads share the powers.
// Source: Edelsbrunner, The union of balls and its dual shape (1995); docs/explanation/filtration_and_persistence.md,
//         section 9.
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa {

struct WeightedFiltrationOptions {
  /// Whether values are signed roots of powers: √p, or −√−p for a negative p. A ball of radius R then appears at −R.
  bool roots = false;
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is the number of triangulated balls, then 0
};

/// Computes the filtration for solid_persistence(). All values are powers or signed roots. `point_alpha` has the values
/// of balls: infinity for a ball without a cell, or equal to one of lower index. SolidFiltration::delaunay has the
/// regular triangulation; `isolated` lists the balls without a cell.
/// Requires: what regular_triangulation() requires. Throws: what regular_triangulation() throws.
RBPA_API SolidFiltration weighted_filtration(std::span<const Point3> centers, std::span<const double> radii,
                                             const WeightedFiltrationOptions& options = {});

}  // namespace rbpa
