// What:   computes the radius at which each tetrahedron enters the solid alpha complex, selects the complex of any
//         alpha by these radii, and finds the least alpha at which the complex or a component has a share of the
//         points.
// Law:    a tetrahedron is in the complex of alpha exactly if its radius is at most alpha, for every double alpha > 0.
// Cost:   some 70 nanoseconds a tetrahedron for circumradii(), shared among threads; n log n for auto_alpha(), linear
//         for the other functions.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994); docs/explanation/space.md, section 20.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// Returns the circumradius of each tetrahedron, rounded up to a double; infinity for a radius above all doubles.
/// Requires: finite points, fewer than 2^32 − 1; the four points of a simplex are not in one plane (not checked).
/// Throws:   InvalidInput that names the number of points, the first point that is not finite, or the first simplex
///           with a corner that is not a point; Cancelled.
RBPA_API std::vector<double> circumradii(std::span<const Point3> points,
                                         std::span<const std::array<std::uint32_t, 4>> simplices,
                                         MaxThreads threads = 0, const GoOn& go_on = {});

/// Returns the least alpha at which at least the fraction `share` of the distinct points are corners of tetrahedra. A
/// share below 1 ignores outliers. Shares are quotients count / all in double, so that 7 of 100 points are a share of
/// 0.07. Returns infinity if there is no tetrahedron.
/// Requires: `delaunay` is solid() at infinity, and `radii` are its circumradii(); 0 < share ≤ 1.
/// Throws:   ContractViolation if the number of radii differs or the share is out of its bounds; Cancelled.
RBPA_API double min_alpha(const Solid& delaunay, std::span<const double> radii, double share = 1,
                          const GoOn& go_on = {});

/// Returns the least alpha at which one solid component, connected through triangles, has at least the fraction `share`
/// of the distinct points as corners. Other components may exist. Returns infinity if there is no tetrahedron.
/// Requires: what min_alpha() requires; `delaunay` has neighbors.
/// Throws:   as min_alpha(); ContractViolation if neighbors are missing.
RBPA_API double auto_alpha(const Solid& delaunay, std::span<const double> radii, double share = 1,
                           const GoOn& go_on = {}, MaxThreads threads = 0);

/// Returns the tetrahedra of a solid whose radius is at most alpha, with neighbors if `solid` has neighbors. If `solid`
/// is the Delaunay triangulation, the result is solid() with this alpha.
/// Requires: `radii` has the radius of each tetrahedron, in the order of `solid`; only the number of radii is checked.
/// Throws:   ContractViolation if the number of radii differs; InvalidInput when alpha is not above 0.
RBPA_API Solid within(const Solid& solid, std::span<const double> radii, double alpha, MaxThreads threads = 0);

}  // namespace rbpa
