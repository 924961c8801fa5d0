// What: which triangles and edges of a Delaunay triangulation, of points or of a box that repeats, are in the full
//       alpha complex.
// Law:  a simplex is in the complex if a ball of radius at most alpha has its corners on its sphere and no point inside. So it is if one
//       of a higher dimension that it is a face of is in it, and otherwise if the least sphere through its corners is within alpha and no corner
//       of those around it is inside.
// How:  each tetrahedron is asked where it is, about its own corners: across the side of a box a neighbor has an image
//       of the common face, and as images are exact, it gives the same answer there.
// Cost: linear in the tetrahedra; exact predicates where neither tetrahedron at a triangle is in the complex.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/full/edges.h"
#include "rbpa/space/full/triangulated.h"

namespace rbpa::space {

class FacesWithin {
 public:
  /// Keeps references. Requires: a Delaunay triangulation with neighbors, and its radii; alpha above 0.
  FacesWithin(const Triangulated& delaunay, std::span<const double> radii, double alpha, Threads& threads,
              const std::function<bool()>& go_on = {});

  bool has_tetrahedron(std::uint32_t t) const { return radii_[t] <= alpha_; }
  /// The triangle across from corner k of a tetrahedron.
  bool has_triangle(std::uint32_t t, std::size_t k) const { return has_triangle_[4 * std::size_t{t} + k] != 0; }
  /// How many tetrahedra of the complex have it for a face.
  unsigned tetrahedra_at(std::uint32_t t, std::size_t k) const {
    const std::uint32_t beyond = delaunay_.neighbors[t][k];
    return static_cast<unsigned>(has_tetrahedron(t)) +
           static_cast<unsigned>(beyond != Solid::none && has_tetrahedron(beyond));
  }
  bool is_on_hull(std::uint32_t t, std::size_t k) const { return delaunay_.neighbors[t][k] == Solid::none; }
  /// A triangle is at two tetrahedra, but one of them is the first.
  bool is_first(std::uint32_t t, std::size_t k) const {
    return delaunay_.neighbors[t][k] == Solid::none || t < delaunay_.neighbors[t][k];
  }

  /// The edge with these tetrahedra around it: by a triangle, or alone.
  bool has_edge(std::span<const EdgeAt> ring) const { return has_triangle_at(ring) || has_edge_alone(ring); }
  bool has_triangle_at(std::span<const EdgeAt> ring) const {
    return std::any_of(ring.begin(), ring.end(), [&](const EdgeAt& at) {
      const auto [k, l] = others(at);
      return has_triangle(at.tetrahedron, k) || has_triangle(at.tetrahedron, l);
    });
  }
  /// Requires: no triangle at the edge is in the complex.
  bool has_edge_alone(std::span<const EdgeAt> ring) const { return is_edge_alone(delaunay_, ring, alpha_); }

 private:
  Triangulated delaunay_;
  std::span<const double> radii_;
  double alpha_;
  std::vector<std::uint8_t> has_triangle_;  // of each corner of a tetrahedron
};

}  // namespace rbpa::space
