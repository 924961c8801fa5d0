// What: decides which shells the ball can reach from outside of all shells, and counts for each closed surface the
//       others that enclose it.
// Law:  a shell is outer if no shell, itself included, winds around the center of a ball that rests on it. The center
//       is at least the radius away from all points. Winding numbers are exact; the center is rounded. If the radius is
//       above 10⁻⁹ of the coordinates, rounding matters at most at triangles whose circumcircle is nearly a great
//       circle of the ball. docs/explanation/surfaces.md, section 21.
// Cost: a sort of the triangles; and for each triangle, a test of the centers in its range of y, of which each shell
//       has one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa {

/// Returns for each component whether it is outer: no component, itself included, encloses the ball that rolls on it. A
/// scan of a closed object has an outer shell, and an inner shell, on which the ball rolls inside.
/// Requires: `shells` are the exposed_triangles() of `points` and `radius`, and `components` their components.
/// Throws:   InvalidInput when the radius is not finite and above 0; ContractViolation when a component is open, an
///           index does not exist, or the components are visibly not those of `shells`; Cancelled.
RBPA_API std::vector<bool> outer_shells(std::span<const Point3> points, double radius, const Surface& shells,
                                        const SurfaceComponents& components, const GoOn& go_on = {});

/// Returns for each closed surface the exact number of other surfaces in which it lies: 0 for a body outside of all
/// others, 1 for the wall of a cavity or for a body within a body. A ray from the lexicographically least corner that
/// is on no other surface decides. If every corner is on some other surface, the least corner decides, and the surfaces
/// on which it lies do not count. A surface without a triangle lies in none.
/// Requires: finite points; each surface is closed, with its triangles in any order and orientation; not checked.
/// Throws:   ContractViolation when a corner is not an index of a point; Cancelled.
/// Cost:     for each triangle, a test of the rays in its range of y, z; n log n if few surfaces overlap there.
RBPA_API std::vector<std::size_t> nesting_depths(std::span<const Point3> points,
                                                 std::span<const std::vector<std::array<std::uint32_t, 3>>> surfaces,
                                                 const GoOn& go_on = {});
/// Returns for each closed component of a surface the number of others in which it lies; 0 for open components.
/// Requires: `surface` is a surface of `points`, and `components` are its components.
/// Throws:   ContractViolation when an index does not exist or the components are visibly not those of `surface`;
///           Cancelled.
RBPA_API std::vector<std::size_t> nesting_depths(std::span<const Point3> points, const Surface& surface,
                                                 const SurfaceComponents& components, const GoOn& go_on = {});

}  // namespace rbpa
