// What:   the radius at which each tetrahedron enters the solid alpha complex; what is in the complex of one alpha or the other then needs
//         no geometry. The two radii at which the complex first has all points, and first has them in one piece.
// Law:    a tetrahedron is in the complex of alpha exactly if its radius is at most alpha, for every double alpha.
// Cost:   some 70 nanoseconds a tetrahedron for circumradii(), shared among threads; the others are about linear.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994); docs/solid.md, section 10.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"

namespace rbpa {

/// The circumradius of each tetrahedron, rounded up to a double; infinity above all doubles.
/// Requires: finite points; simplices of four of them that are in no plane. `threads` as in SolidOptions.
/// Throws:   InvalidInput that names the first point that is not finite, or the first simplex with another corner; Cancelled when
///           `go_on`, which here and below is called every few milliseconds, by one thread at a time, returns false.
RBPA_API std::vector<double> circumradii(std::span<const Point3> points,
                                         std::span<const std::array<std::uint32_t, 4>> simplices, unsigned threads = 0,
                                         const std::function<bool()>& go_on = {});

/// The least alpha at which a share of the points, each of them or so many that outliers do not decide, are corners of tetrahedra; infinity where there is no
/// tetrahedron.
/// Requires: the result of solid() at infinity, and its circumradii; 0 < share ≤ 1. Throws ContractViolation otherwise.
RBPA_API double min_alpha(const Solid& delaunay, std::span<const double> radii, double share = 1,
                          const std::function<bool()>& go_on = {});

/// The least alpha at which one solid component has a share of the points for corners: moreover in one piece, connected through triangles.
/// Others may be in it that have no corner for themselves. Infinity where there is no tetrahedron.
/// Requires: as min_alpha(), with neighbors.
RBPA_API double auto_alpha(const Solid& delaunay, std::span<const double> radii, double share = 1,
                           const std::function<bool()>& go_on = {});

/// The tetrahedra of radius at most alpha of a solid, with neighbors if it has any: from the Delaunay triangulation, that is
/// solid() with this alpha.
/// Requires: the radii of its tetrahedra. Throws as min_alpha(); InvalidInput when alpha is not above 0.
RBPA_API Solid within(const Solid& solid, std::span<const double> radii, double alpha);

}  // namespace rbpa
