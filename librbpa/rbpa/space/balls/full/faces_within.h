// What: finds the triangles and edges of a Delaunay triangulation (also of a periodic box) that are in the full alpha
//       complex, and those of a regular triangulation that are in the dual complex of balls.
// Law:  a simplex is in the full alpha complex if a ball of radius at most alpha has all its corners on the sphere and
//       no point inside. Equivalently: a simplex of higher dimension with this face is in the complex; or the least
//       sphere through its corners has a radius of at most alpha and contains no corner of the simplices around it. For
//       balls, the power of the simplex is at most 0, and no corner around it conflicts (orthosphere.h).
// How:  each triangle is tested in its first tetrahedron. In a periodic box, the other tetrahedron may have an image of
//       the triangle instead; tests of images are exact, so the result holds for both tetrahedra.
// Cost: linear in the tetrahedra; exact predicates where neither tetrahedron at a triangle is in the complex.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/balls/full/triangulated.h"

namespace rbpa::space {

/// The rule that decides which simplices are in a complex by themselves. Any thread may call the functions.
class SimplexRule {
 public:
  virtual ~SimplexRule() = default;
  virtual bool has_tetrahedron(std::uint32_t t) const = 0;
  /// Returns whether the triangle across from corner k of t is within the limit, and corner k does not conflict.
  virtual bool has_triangle_beside(std::uint32_t t, std::size_t k) const = 0;
  virtual bool has_edge(std::span<const EdgeAt> ring) const = 0;
};

/// Returns whether the center of ball i is in the ball's own power cell. If so, a ball in no edge of the dual complex
/// is a vertex of the complex. `star` has the tetrahedra at the ball. Requires: `regular` is the regular triangulation
/// of balls with these radii.
bool is_center_in_cell(const Triangulated& regular, std::span<const double> ball_radii, std::uint32_t i,
                       std::span<const std::uint32_t> star);

class FacesWithin {
 public:
  /// Finds the faces of the full alpha complex. Keeps references. Requires: a Delaunay triangulation with neighbors,
  /// and its circumradii; alpha above 0.
  FacesWithin(const Triangulated& delaunay, std::span<const double> radii, double alpha, Threads& threads,
              const GoOn& go_on = {});
  /// Finds the faces of the dual complex of balls. Keeps references. Requires: their regular triangulation with
  /// neighbors, and a radius for each vertex.
  FacesWithin(const Triangulated& regular, std::span<const double> ball_radii, Threads& threads,
              const GoOn& go_on = {});
  FacesWithin(const Triangulated& cells, std::shared_ptr<const SimplexRule> rule, Threads& threads,
              const GoOn& go_on = {});

  bool has_tetrahedron(std::uint32_t t) const { return has_tetrahedron_[t] != 0; }
  /// Returns whether a tetrahedron is in the complex and has no face on the hull.
  bool is_inside(std::uint32_t t) const { return has_tetrahedron_[t] == 2; }
  /// Returns whether the triangle across from corner k of tetrahedron t is in the complex.
  bool has_triangle(std::uint32_t t, std::size_t k) const { return has_triangle_[4 * std::size_t{t} + k] != 0; }
  /// Returns the number of tetrahedra of the complex that have the triangle across from corner k of t as a face.
  unsigned tetrahedra_at(std::uint32_t t, std::size_t k) const {
    const std::uint32_t beyond = delaunay_.neighbors[t][k];
    return static_cast<unsigned>(has_tetrahedron(t)) +
           static_cast<unsigned>(beyond != Solid::none && has_tetrahedron(beyond));
  }
  bool is_on_hull(std::uint32_t t, std::size_t k) const { return delaunay_.neighbors[t][k] == Solid::none; }
  /// Returns whether t is the first tetrahedron at the triangle across from its corner k. Of two tetrahedra at a
  /// triangle, one is the first.
  bool is_first(std::uint32_t t, std::size_t k) const {
    return delaunay_.neighbors[t][k] == Solid::none || t < delaunay_.neighbors[t][k];
  }

  /// Returns whether the edge with these tetrahedra around it is in the complex: as an edge of a triangle of the
  /// complex, or by itself.
  bool has_edge(std::span<const EdgeAt> ring) const { return has_triangle_at(ring) || has_edge_alone(ring); }
  bool has_triangle_at(std::span<const EdgeAt> ring) const {
    return std::any_of(ring.begin(), ring.end(), [&](const EdgeAt& at) {
      const auto [k, l] = others(at);
      return has_triangle(at.tetrahedron, k) || has_triangle(at.tetrahedron, l);
    });
  }
  /// Returns whether the edge is in the complex by itself. Requires: no triangle at the edge is in the complex.
  bool has_edge_alone(std::span<const EdgeAt> ring) const { return rule_->has_edge(ring); }

 private:
  Triangulated delaunay_;
  std::shared_ptr<const SimplexRule> rule_;
  std::vector<std::uint8_t> has_tetrahedron_;  // 1 if in the complex, 2 if in addition no face is on the hull
  std::vector<std::uint8_t> has_triangle_;     // for each tetrahedron: the triangles across from its four corners
};

}  // namespace rbpa::space
