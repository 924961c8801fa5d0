// What: which triangles and edges of a Delaunay triangulation are in the full alpha complex.
// Law:  a simplex is in the complex if a ball of radius at most alpha has its corners on its sphere and no point inside. So it is if one
//       of a higher dimension that it is a face of is in it, and otherwise if the least sphere through its corners is within alpha and no corner
//       of those around it is inside.
// Cost: linear in the tetrahedra; exact predicates where neither tetrahedron at a triangle is in the complex.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/going_on.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/simplices_at.h"
#include "rbpa/solid.h"

namespace rbpa::space {

class FacesWithin {
 public:
  /// Keeps references. Requires: a Delaunay triangulation with neighbors, and its radii; alpha above 0.
  FacesWithin(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii, double alpha,
              Threads& threads, const std::function<bool()>& go_on = {});

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

  /// The edge from a to b, around which these tetrahedra are: by a triangle, or alone.
  bool has_edge(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> around) const {
    return has_triangle_at(a, b, around) || has_edge_alone(a, b, around);
  }
  bool has_triangle_at(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> around) const;
  /// Requires: no triangle at the edge is in the complex.
  bool has_edge_alone(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> around) const;

 private:
  /// Which corner of the tetrahedron across from corner k is across from t.
  std::size_t back(std::uint32_t t, std::size_t k) const {
    const auto& others = delaunay_.neighbors[delaunay_.neighbors[t][k]];
    return static_cast<std::size_t>(std::find(others.begin(), others.end(), t) - others.begin());
  }

  std::span<const Point3> points_;
  const Solid& delaunay_;
  std::span<const double> radii_;
  double alpha_;
  std::vector<std::uint8_t> has_triangle_;  // of each corner of a tetrahedron
};

/// Calls visit(b, tetrahedra around the edge from a to b) for each edge at a whose other end has a greater index, ascending. `ends` is
/// memory to be used again.
template <typename Visit>
void for_each_edge_up(std::uint32_t a, std::span<const std::uint32_t> star, const Solid& delaunay,
                      std::vector<std::pair<std::uint32_t, std::uint32_t>>& ends, Visit visit) {
  ends.clear();
  for (const std::uint32_t t : star)
    for (const std::uint32_t b : delaunay.simplices[t])
      if (b > a) ends.emplace_back(b, t);
  std::sort(ends.begin(), ends.end());
  std::vector<std::uint32_t> around;
  for (std::size_t first = 0; first < ends.size();) {
    around.clear();
    std::size_t last = first;
    for (; last < ends.size() && ends[last].first == ends[first].first; ++last) around.push_back(ends[last].second);
    visit(ends[first].first, std::span<const std::uint32_t>(around));
    first = last;
  }
}

/// Calls is_meant(a, b, tetrahedra around the edge) for each edge, a < b, in any thread, and then join(a, b) for those it returned true for,
/// one by one, in order. Throws: Cancelled where `go_on` returns false.
template <typename IsMeant, typename Join>
void for_each_edge(const Solid& delaunay, const TetrahedraAt& stars, std::size_t bound, Threads& threads,
                   const IsMeant& is_meant, const Join& join, const std::function<bool()>& go_on = {}) {
  constexpr std::size_t points_at_a_time = 1u << 10;
  struct Workspace {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends, edges;
  };
  AskFromAnyThread ask(go_on);
  in_order<Workspace>(
      threads, (bound + points_at_a_time - 1) / points_at_a_time,
      [&](std::size_t part, Workspace& w) {
        ask();
        w.edges.clear();
        const std::size_t end = std::min((part + 1) * points_at_a_time, bound);
        for (auto a = static_cast<std::uint32_t>(part * points_at_a_time); a < end; ++a)
          for_each_edge_up(a, stars[a], delaunay, w.ends, [&](std::uint32_t b, std::span<const std::uint32_t> around) {
            if (is_meant(a, b, around)) w.edges.emplace_back(a, b);
          });
      },
      [&](std::size_t, Workspace& w) {
        for (const auto& edge : w.edges) join(edge.first, edge.second);
      },
      [](std::size_t, Workspace&) {});
}

}  // namespace rbpa::space
