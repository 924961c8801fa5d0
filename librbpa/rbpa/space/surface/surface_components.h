// What: finds the components of a surface with their sizes and genus, chooses some, and removes the others.
// Law:  a component is connected through glued sides; pieces that only touch are two components. All measures are
//       functions of the oriented triangles and their gluing: the bits are equal for any order of points and triangles.
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
  std::size_t triangles = 0;        ///< number of triangles
  std::size_t boundary_sides = 0;   ///< number of sides without a neighbor; 0 if the component is closed
  std::size_t boundary_curves = 0;  ///< number of surface_curves() (holes.h)
  double area = 0;                  ///< area in squared units of the points
  double volume = 0;  ///< volume in cubed units; negative for a component turned inside out, 0 for an open one
  Point3 low, high;   ///< corners of the bounding box: the least and the greatest coordinates

  bool is_closed() const { return boundary_sides == 0; }  ///< whether each side has a neighbor
};

struct SurfaceComponents {
  /// The components by descending area; equal areas by descending volume, then by lexicographically least triangle.
  std::vector<SurfaceComponent> all;
  std::vector<std::uint32_t> number;  ///< for each triangle, the position of its component in `all`
};

/// Computes the components of a surface.
/// Requires: `surface` is a surface of `points`.
/// Throws:   ContractViolation as require_linked() (triangle_arrays.h) throws it; Cancelled.
RBPA_API SurfaceComponents surface_components(std::span<const Point3> points, const Surface& surface,
                                              const GoOn& go_on = {});

/// Returns the genus of each component, its number of handles. Each fan of triangles counts as one vertex.
/// Requires: `components` are those of `surface`.
/// Throws:   ContractViolation when the components are visibly not those of `surface`, or as require_linked() throws it
///           for any indices of points; Cancelled.
/// Cost:     linear.
RBPA_API std::vector<std::size_t> genus_of(const Surface& surface, const SurfaceComponents& components,
                                           const GoOn& go_on = {});

/// A choice of the components of exposed_triangles(), which are closed shells.
enum class ShellChoice : std::uint8_t {
  all,      ///< all components
  outer,    ///< the shells that outer_shells() calls outer
  largest,  ///< of the outer shells that have at least `min_triangles` and `min_area`, the one of largest area
};

/// A choice of components; by default all.
struct ComponentChoice {
  ShellChoice shell = ShellChoice::all;
  /// Maximum number of components; those of largest area are kept. If absent, no limit. Ignored for `largest`.
  std::optional<std::size_t> max_components = {};
  std::size_t min_triangles = 0;  ///< minimum number of triangles of a component
  double min_area = 0;            ///< minimum area of a component, in squared units of the points

  /// Returns whether the choice keeps every component of any surface.
  bool keeps_all() const {
    return shell == ShellChoice::all && !max_components && min_triangles == 0 && !(min_area > 0);
  }
};

/// Returns for each component whether it is kept. Of the components that are chosen shells with at least
/// `min_triangles` and `min_area`, the `max_components` of largest area are kept.
/// Requires: `components` are in the order of surface_components(). `outer` has for each component whether it is outer,
///           as outer_shells() returns; `outer` is not read if all shells are chosen.
/// Throws:   ContractViolation when `outer` is read and does not have one value for each component.
RBPA_API std::vector<bool> choose_components(const SurfaceComponents& components, const std::vector<bool>& outer,
                                             const ComponentChoice& choice);

/// Counts of the components that are dropped from a surface. Members `of_…` are totals over all components.
struct DroppedComponents {
  std::size_t components = 0, triangles = 0, genus = 0;
  std::size_t points = 0;  ///< number of points that are in dropped triangles only
  double area = 0;         ///< in squared units of the points
  std::size_t of_components = 0, of_triangles = 0, of_genus = 0;
  double of_area = 0;

  /// Return the dropped fraction of all triangles, of the whole area, and of a given whole; 0 if the whole is 0.
  double triangle_share() const { return share(static_cast<double>(triangles), static_cast<double>(of_triangles)); }
  double area_share() const { return share(area, of_area); }
  static double share(double part, double whole) { return whole > 0 ? part / whole : 0; }
};

/// Counts the components that are not kept, their triangles, and the points that are in dropped triangles only.
/// Requires: `surface` is a surface of `points`; `components` are its components, and `kept` says for each whether it
///           is kept.
/// Throws:   ContractViolation when `kept` does not have one value for each component, when a corner is not an index of
///           a point, or as genus_of() throws it; Cancelled.
/// Cost:     linear.
RBPA_API DroppedComponents dropped_components(std::span<const Point3> points, const std::vector<bool>& kept,
                                              const Surface& surface, const SurfaceComponents& components,
                                              const GoOn& go_on = {});

/// Returns the triangles of the components that are kept, with the same gluing and in the same order.
/// Requires: `components` are those of `surface`, and `kept` says for each whether it is kept.
/// Throws:   ContractViolation when sizes differ, or a triangle has a component that does not exist.
RBPA_API Surface keep_components(const Surface& surface, const SurfaceComponents& components,
                                 const std::vector<bool>& kept);

/// Returns the triangles that are kept, in the given order; their sides at dropped triangles become boundary. `levels`
/// are those of the kept triangles; `duplicates` and `distinct` stay.
/// Requires: each triangle has three neighbors that exist or are `none`; not checked.
/// Throws:   ContractViolation when `kept` does not have one value for each triangle.
RBPA_API Surface keep_triangles(const Surface& surface, const std::vector<bool>& kept);

}  // namespace rbpa
