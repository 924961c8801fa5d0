// What: the components of a surface with their sizes and genus, a choice of them, and the surface without the others.
// Law:  a component is connected through glued sides; pieces that only touch are two components. All numbers are
//       functions of the triangles as sets of points and of their gluing: the same to the last bit in any order of the
//       points.
// Cost: linear, and a sort of the components.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

struct SurfaceComponent {
  std::size_t triangles = 0;
  std::size_t boundary_sides = 0;  ///< number of sides without a neighbor; 0 if the component is closed
  std::size_t boundary_curves = 0;
  double area = 0;    ///< in squared units of the points
  double volume = 0;  ///< of a closed component, negative if the triangles face the enclosed space; otherwise 0
  Point3 low, high;   ///< opposite corners of its box

  bool is_closed() const { return boundary_sides == 0; }
};

struct SurfaceComponents {
  std::vector<SurfaceComponent> all;  ///< the largest area first; of equal ones the largest volume
  std::vector<std::uint32_t> number;  ///< for each triangle, its component in `all`
};

/// Computes the components of a surface.
/// Requires: a surface of these points.
/// Throws:   ContractViolation when a corner is none of these points, or a triangle is not a neighbor of its neighbor;
///           Cancelled.
RBPA_API SurfaceComponents surface_components(std::span<const Point3> points, const Surface& surface,
                                              const GoOn& go_on = {});

/// Returns the genus of each component, the number of its handles, with a vertex for each fan of triangles.
/// Requires: the components of this surface.
/// Throws:   ContractViolation on other sizes, and as split_fans().
/// Cost:     that of split_fans().
RBPA_API std::vector<std::size_t> genus_of(const Surface& surface, const SurfaceComponents& components,
                                           const GoOn& go_on = {});

enum class ShellChoice : std::uint8_t { all, outer, largest };

/// A choice of components; by default all.
struct ComponentChoice {
  ShellChoice shell = ShellChoice::all;     ///< of triangles that form closed shells; largest: the largest outer one
  std::optional<std::size_t> largest = {};  ///< maximum number of components: those of largest area are kept
  std::size_t least_triangles = 0;
  double least_area = 0;

  bool keeps_all() const { return shell == ShellChoice::all && !largest && least_triangles == 0 && !(least_area > 0); }
};

/// Returns for each component whether it is kept: it is one of the wanted shells, is not too small, and is among the
/// largest of these.
/// Requires: for each component whether it is outer, as outer_shells() returns it, unless the choice is all shells.
RBPA_API std::vector<bool> kept_components(const SurfaceComponents& components, const std::vector<bool>& outer,
                                           const ComponentChoice& choice);

/// Counts of the components dropped from a surface, and of the whole surface before.
struct DroppedComponents {
  std::size_t components = 0, triangles = 0, genus = 0;
  std::size_t points = 0;  ///< left without a triangle
  double area = 0;
  std::size_t of_components = 0, of_triangles = 0, of_genus = 0;
  double of_area = 0;

  double triangle_share() const { return share(static_cast<double>(triangles), static_cast<double>(of_triangles)); }
  double area_share() const { return share(area, of_area); }
  static double share(double part, double whole) { return whole > 0 ? part / whole : 0; }
};

/// Counts the components that are not kept, their triangles, and the points that no other triangle has.
/// Requires: a surface of these points, its components, and for each whether it is kept.
/// Throws:   ContractViolation on other sizes; Cancelled.
/// Cost:     that of genus_of(); nothing if all are kept.
RBPA_API DroppedComponents dropped_components(std::span<const Point3> points, const std::vector<bool>& kept,
                                              const Surface& surface, const SurfaceComponents& components,
                                              const GoOn& go_on = {});

/// Returns the triangles of the components that are kept, glued as they were, in the same order.
/// Requires: the components of this surface, and for each whether it is kept.
/// Throws:   ContractViolation on other sizes.
RBPA_API Surface keep_components(const Surface& surface, const SurfaceComponents& components,
                                 const std::vector<bool>& kept);

/// Returns the triangles that are kept, in the same order; their sides at other triangles become boundary.
/// Throws: ContractViolation on another size.
RBPA_API Surface keep_triangles(const Surface& surface, const std::vector<bool>& kept);

}  // namespace rbpa
