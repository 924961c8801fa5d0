#include "rbpa/space/solid/boundary/outside.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/fresh_vector.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/solid/boundary/connected.h"
#include "rbpa/space/solid/boundary/glue_outside.h"

namespace rbpa::space {
namespace {

/// The three corners of a tetrahedron other than the center.
using LinkTriangle = std::array<std::uint32_t, 3>;

/// Returns whether the arc from a direction within `from` to a direction within `to` crosses the arc from p to q, on
/// the sphere of directions from `center`. A point stands for its direction. The directions within the triangles are
/// moved off the edges of the tetrahedra by infinitesimals of different orders, so that the arc never passes through a
/// corner. Exact. Requires: neither triangle is in a plane with `center`; p, q and `center` are on no line.
bool arcs_cross(std::span<const Point3> points, std::uint32_t center, const LinkTriangle& from, const LinkTriangle& to,
                std::uint32_t p, std::uint32_t q) {
  const auto sign = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return orientation(points[center], points[i], points[j], points[k]);
  };
  // A direction within (a, b, c) is a + ε b + ε² c. The first term that is not 0 gives the side of the arc's plane. The
  // infinitesimals of `to` are smaller, so that their terms come last.
  const auto side_of_arc = [&](std::uint32_t k) {
    for (const std::uint32_t j : to)
      for (const std::uint32_t i : from)
        if (const int side = sign(i, j, k); side != 0) return side;
    return 0;
  };
  const auto side_of_edge = [&](const LinkTriangle& within) {
    for (const std::uint32_t i : within)
      if (const int side = sign(p, q, i); side != 0) return side;
    return 0;
  };
  const int begin = side_of_edge(from), end = side_of_edge(to);
  if (begin == end) return false;
  const int at_p = side_of_arc(p), at_q = side_of_arc(q);
  // The planes of the arcs meet in two opposite directions. The arcs cross if both pass through one of these
  // directions.
  return at_p != at_q && at_q == -end;
}

/// A triangle of the boundary at one of its corners, with all data used there, so that no distant memory is read.
struct Corner {
  std::uint32_t triangle;
  std::uint32_t head;         // the next corner of the triangle
  std::uint32_t tetrahedron;  // the tetrahedron behind the triangle
  std::uint32_t inside,
      outside;  // the next triangle around the corner, as glued through the solid and through the outside
};

/// A triangle of the boundary at the current point.
struct CornerAt {
  std::uint32_t triangle, head;
  std::uint32_t region;  // region of the link: tetrahedra connected through faces at the point
  std::uint32_t part;    // part of the link: regions that touch are one part
  std::uint32_t fan;     // fan of triangles glued through the outside
};

/// A visit of all points, one after the other, that joins sets of Outside::surfaces where a point connects them.
class AtPoints {
 public:
  AtPoints(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary,
           const std::vector<Triangle>& glued_outside, Outside& outside)
      : points_(points),
        solid_(solid),
        triangles_(boundary.surface.triangles),
        glued_inside_(boundary.surface.neighbors),
        glued_outside_(glued_outside),
        behind_(boundary.tetrahedra),
        outside_(outside) {}

  void look_at_all() {
    std::vector<std::uint32_t> end(points_.size() + 1, 0);
    for (const Triangle& t : triangles_)
      for (const std::uint32_t i : t) ++end[i + 1];
    for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
    meshops::FreshVector<Corner> corners(3 * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t next = (k + 1) % 3;
        corners[end[triangles_[t][k]]++] = {t, triangles_[t][next], behind_[t], glued_inside_[t][next],
                                            glued_outside_[t][next]};
      }
    for (std::uint32_t v = 0, begin = 0; v < points_.size(); begin = end[v++]) {
      if (begin == end[v]) continue;
      ++outside_.points;
      look_at(v, std::span<const Corner>(corners).subspan(begin, end[v] - begin));
    }
  }

  std::size_t inner_fans() const { return fans_; }
  std::size_t regions() const { return regions_; }

 private:
  using Row = std::array<std::uint32_t, 4>;

  void look_at(std::uint32_t v, std::span<const Corner> corners) {
    const std::size_t fans = find_fans(corners, [](const Corner& c) { return c.inside; });
    fans_ += fans;
    if (fans == 1) {
      ++regions_;
      return;
    }
    if (seen_.empty()) seen_.resize(solid_.simplices.size(), 0);
    at_.clear();
    const std::uint32_t first_region = next_region_;
    std::size_t left = corners.size();  // number of corners in tetrahedra that are not reached yet
    for (const Corner& c : corners) {
      if (seen_[c.tetrahedron] < first_region) left = pass_region(v, c.tetrahedron, left);
      at_.push_back({c.triangle, c.head, seen_[c.tetrahedron] - first_region, 0, 0});
    }
    const std::uint32_t regions = next_region_ - first_region;
    regions_ += regions;
    if (regions == 1) return;
    find_fans(corners, [](const Corner& c) { return c.outside; });
    for (std::size_t i = 0; i < at_.size(); ++i) at_[i].fan = fan_[i];
    find_parts(regions);
    join_fans(v);
  }

  /// Sets fan_[i] to the number of the fan of corners[i]. Returns the number of fans. Requires: `corners` are those at
  /// one point, ascending by triangle; next_of(corner) is the next triangle around the point.
  template <typename Next>
  std::size_t find_fans(std::span<const Corner> corners, const Next& next_of) {
    constexpr std::uint32_t unseen = 0xffffffff;
    constexpr std::size_t few = 16;  // up to this number, comparing all corners is faster than a search
    next_.resize(corners.size());
    fan_.assign(corners.size(), unseen);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t next = next_of(corners[i]);
      std::size_t place = 0;
      if (corners.size() <= few)
        for (const Corner& c : corners) place += c.triangle < next ? 1u : 0u;
      else
        place =
            static_cast<std::size_t>(std::lower_bound(corners.begin(), corners.end(), next,
                                                      [](const Corner& c, std::uint32_t t) { return c.triangle < t; }) -
                                     corners.begin());
      next_[i] = static_cast<std::uint32_t>(place);
    }
    std::uint32_t fans = 0;
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      if (fan_[i] != unseen) continue;
      for (std::uint32_t at = i; fan_[at] == unseen; at = next_[at]) fan_[at] = fans;
      ++fans;
    }
    return fans;
  }

  /// Marks in seen_ the tetrahedra of one region: those connected with `from` through faces at v. `left` is the number
  /// of boundary corners at v that are in no region yet. Returns the number that remains; stops at 0.
  std::size_t pass_region(std::uint32_t v, std::uint32_t from, std::size_t left) {
    seen_[from] = next_region_;
    reached_.assign(1, from);
    for (std::size_t i = 0; i < reached_.size() && left > 0; ++i) {
      const std::uint32_t t = reached_[i];
      const Row &corners = solid_.simplices[t], &neighbors = solid_.neighbors[t];
      const std::uint32_t at = place_of(v, corners);
      meshops::require(corners[at] == v, not_its_boundary);
      for (std::uint32_t k = 0; k < 4; ++k) {
        if (k == at) continue;
        const std::uint32_t next = neighbors[k];
        if (next == Solid::none) {
          --left;
        } else if (seen_[next] != next_region_) {
          seen_[next] = next_region_;
          reached_.push_back(next);
        }
      }
    }
    ++next_region_;
    return left;
  }

  /// Joins regions of the link that touch in a point of the link. A point of the link is an edge of the complex from v;
  /// the regions touch if both have a boundary triangle at this edge.
  void find_parts(std::uint32_t regions) {
    std::sort(at_.begin(), at_.end(), [](const CornerAt& a, const CornerAt& b) { return a.head < b.head; });
    part_.resize(regions);
    std::iota(part_.begin(), part_.end(), std::uint32_t{0});
    for (std::size_t i = 1; i < at_.size(); ++i)
      if (at_[i].head == at_[i - 1].head) {
        const auto [low, high] = std::minmax({least_of_part(at_[i].region), least_of_part(at_[i - 1].region)});
        part_[high] = low;
      }
    for (CornerAt& c : at_) c.part = least_of_part(c.region);
  }
  std::uint32_t least_of_part(std::uint32_t region) {
    while (part_[region] != region) region = part_[region] = part_[part_[region]];
    return region;
  }

  /// Joins the surfaces of fans of different parts of the link that no part of the link separates.
  void join_fans(std::uint32_t v) {
    std::sort(at_.begin(), at_.end(),
              [](const CornerAt& a, const CornerAt& b) { return std::pair(a.part, a.fan) < std::pair(b.part, b.fan); });
    if (at_.front().part == at_.back().part) return;
    std::size_t parts = 1, fans = 1;
    for (std::size_t i = 1; i < at_.size(); ++i) {
      parts += at_[i].part != at_[i - 1].part;
      fans += at_[i].fan != at_[i - 1].fan;
    }
    if (parts == fans) {  // each part has one fan: no part separates two others
      for (const CornerAt& c : at_) outside_.surfaces.join(at_.front().triangle, c.triangle);
      return;
    }
    // The place of each fan: for each part with several fans, the fan of this part that faces the fan.
    std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>> places;  // second: a triangle of the fan
    std::vector<std::span<const CornerAt>> by_part;
    for (std::size_t i = 0, end = 0; i < at_.size(); i = end) {
      while (end < at_.size() && at_[end].part == at_[i].part) ++end;
      by_part.push_back(std::span(at_).subspan(i, end - i));
    }
    for (const auto& of : by_part)
      for (std::size_t i = 0; i < of.size(); ++i)
        if (i == 0 || of[i].fan != of[i - 1].fan) places.emplace_back(std::vector<std::uint32_t>(), of[i].triangle);
    for (const auto& around : by_part) {
      if (around.front().fan == around.back().fan) continue;
      auto place = places.begin();
      for (const auto& of : by_part) {
        const std::uint32_t facing = of.data() == around.data() ? 0 : fan_between(v, of, around);
        for (std::size_t i = 0; i < of.size(); ++i)
          if (i == 0 || of[i].fan != of[i - 1].fan)
            (place++)->first.push_back(of.data() == around.data() ? of[i].fan : facing);
      }
    }
    std::sort(places.begin(), places.end());
    for (std::size_t i = 1; i < places.size(); ++i)
      if (places[i].first == places[i - 1].first) outside_.surfaces.join(places[i].second, places[i - 1].second);
  }

  /// Returns the number of the fan of `part` that faces `from`, another part: an arc from `from` to `part` crosses this
  /// fan an odd number of times.
  std::uint32_t fan_between(std::uint32_t v, std::span<const CornerAt> from, std::span<const CornerAt> part) const {
    const auto link_triangle = [&](const CornerAt& c) {
      const Row& corners = solid_.simplices[behind_[c.triangle]];
      const std::uint32_t at = place_of(v, corners);
      return LinkTriangle{corners[(at + 1) % 4], corners[(at + 2) % 4], corners[(at + 3) % 4]};
    };
    const LinkTriangle begin = link_triangle(from.front()), end = link_triangle(part.front());
    for (std::size_t i = 0, last = 0; i < part.size(); i = last) {
      bool odd = false;
      for (; last < part.size() && part[last].fan == part[i].fan; ++last) {
        const Triangle& corners = triangles_[part[last].triangle];
        const std::uint32_t k = place_of(v, corners);
        if (arcs_cross(points_, v, begin, end, corners[(k + 1) % 3], corners[(k + 2) % 3])) odd = !odd;
      }
      if (odd) return part[i].fan;
    }
    throw meshops::ContractViolation(not_its_boundary);
  }

  std::span<const Point3> points_;
  const Solid& solid_;
  const std::vector<Triangle>& triangles_;
  const std::vector<Triangle>&glued_inside_, &glued_outside_;  // neighbors of each triangle
  const std::vector<std::uint32_t>& behind_;                   // tetrahedra behind the triangles
  Outside& outside_;
  std::vector<std::uint32_t> seen_;  // for each tetrahedron: the last region that contained it
  std::uint32_t next_region_ = 1;
  std::size_t fans_ = 0, regions_ = 0;
  // Data of the current point.
  std::vector<CornerAt> at_;
  std::vector<std::uint32_t> next_, fan_, reached_, part_;
};

}  // namespace

Outside outside_of(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary) {
  const auto& triangles = boundary.surface.triangles;
  require_boundary(points.size(), solid, boundary);
  Outside outside;
  outside.solid_components = connected_through_faces(solid);
  outside.components = outside.solid_components;
  connect_through_points(points.size(), boundary, outside.components);
  outside.surfaces = meshops::DisjointSets(triangles.size());
  Surface glued = boundary.surface;
  outside.edges = triangles.size() * 3 / 2 - glue_outside(points, glued);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t other : glued.neighbors[t])
      if (other < t) outside.surfaces.join(t, other);
  AtPoints at_points(points, solid, boundary, glued.neighbors, outside);
  at_points.look_at_all();

  // Euler characteristics of the boundary, and of the surface just inside of the boundary, on which a tube joins the
  // fans of one region. The open inside contributes minus half of the latter to that of the complex.
  const auto faces = static_cast<std::ptrdiff_t>(triangles.size());
  const auto of_boundary =
      static_cast<std::ptrdiff_t>(outside.points) - static_cast<std::ptrdiff_t>(outside.edges) + faces;
  const auto of_inner = 2 * static_cast<std::ptrdiff_t>(at_points.regions()) -
                        static_cast<std::ptrdiff_t>(at_points.inner_fans()) - faces / 2;
  outside.twice_euler = 2 * of_boundary - of_inner;
  return outside;
}

}  // namespace rbpa::space
