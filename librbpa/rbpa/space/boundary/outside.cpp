#include "rbpa/space/boundary/outside.h"

#include <algorithm>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/fans.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/boundary/connected.h"
#include "rbpa/space/boundary/link_places.h"
#include "rbpa/space/boundary/sides_by_edge.h"
#include "rbpa/space/levels/sub_surface.h"

namespace rbpa::space {
namespace {

template <typename Numbers>
std::uint32_t place_of(std::uint32_t value, const Numbers& numbers) {
  return static_cast<std::uint32_t>(std::find(numbers.begin(), numbers.end(), value) - numbers.begin());
}

/// A corner of the boundary at the point that is looked at; corner k of triangle t is number 3 t + k.
struct CornerAt {
  std::uint32_t corner;
  std::uint32_t region;  // of the link's inside: tetrahedra connected through faces at the point
  std::uint32_t part;    // of the link: regions that touch, as one of them
  std::uint32_t fan;     // of triangles glued through the outside, as one of its corners
};

/// Looks at one point after the other, and joins what is connected through it.
class AtPoints {
 public:
  AtPoints(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary, Outside& outside)
      : points_(points),
        solid_(solid),
        triangles_(boundary.surface.triangles),
        behind_(boundary.tetrahedra),
        outside_(outside),
        inner_fans_(fans_of(arrays_of(boundary.surface))) {}

  /// Requires: the same triangles glued through the outside.
  void look_at_all(const Surface& glued_outside) {
    outer_fans_ = fans_of(arrays_of(glued_outside));
    std::vector<std::uint32_t> end(points_.size() + 1, 0), corners(3 * triangles_.size());
    for (const Triangle& t : triangles_)
      for (const std::uint32_t i : t) ++end[i + 1];
    for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) corners[end[triangles_[t][k]]++] = 3 * t + k;
    for (std::uint32_t v = 0, begin = 0; v < points_.size(); begin = end[v++]) {
      if (begin == end[v]) continue;
      ++outside_.points;
      look_at(v, std::span(corners).subspan(begin, end[v] - begin));
    }
  }

  std::size_t inner_fans() const { return fans_; }
  std::size_t regions() const { return regions_; }

 private:
  void look_at(std::uint32_t v, std::span<const std::uint32_t> corners) {
    std::size_t fans = 0;
    for (const std::uint32_t corner : corners) fans += inner_fans_.is_least(corner) ? 1u : 0u;
    fans_ += fans;
    if (fans == 1) {
      ++regions_;
      return;
    }
    at_.clear();
    const std::uint32_t first_region = next_region_;
    if (seen_.empty()) seen_.resize(solid_.simplices.size(), 0);
    for (const std::uint32_t corner : corners) {
      const std::uint32_t t = behind_[corner / 3];
      if (seen_[t] < first_region) pass_region(v, t);
      at_.push_back({corner, seen_[t], 0, outer_fans_.find(corner)});
    }
    regions_ += next_region_ - first_region;
    find_parts(first_region);
    join_fans(v);
  }

  /// All tetrahedra at v that are reached from one through faces at v.
  void pass_region(std::uint32_t v, std::uint32_t from) {
    seen_[from] = next_region_;
    waiting_.assign(1, from);
    while (!waiting_.empty()) {
      const std::uint32_t t = waiting_.back();
      waiting_.pop_back();
      const std::uint32_t at = place_of(v, solid_.simplices[t]);
      meshops::require(at < 4, not_its_boundary);
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t next = solid_.neighbors[t][k];
        if (k == at || next == Solid::none || seen_[next] == next_region_) continue;
        seen_[next] = next_region_;
        waiting_.push_back(next);
      }
    }
    ++next_region_;
  }

  /// Regions of the link touch at a point of it, an edge of the complex, if a side of each leaves along it.
  void find_parts(std::uint32_t first_region) {
    parts_ = meshops::DisjointSets(next_region_ - first_region);
    const auto head = [&](const CornerAt& c) { return triangles_[c.corner / 3][(c.corner % 3 + 1) % 3]; };
    std::sort(at_.begin(), at_.end(), [&](const CornerAt& a, const CornerAt& b) { return head(a) < head(b); });
    for (std::size_t i = 1; i < at_.size(); ++i)
      if (head(at_[i]) == head(at_[i - 1])) parts_.join(at_[i].region - first_region, at_[i - 1].region - first_region);
    for (CornerAt& c : at_) c.part = parts_.find(c.region - first_region);
  }

  /// Fans of different parts of the link are in the same region of its complement if they can see each other past all parts.
  void join_fans(std::uint32_t v) {
    std::sort(at_.begin(), at_.end(),
              [](const CornerAt& a, const CornerAt& b) { return std::pair(a.part, a.fan) < std::pair(b.part, b.fan); });
    if (at_.front().part == at_.back().part) return;
    std::size_t parts = 1, fans = 1;
    for (std::size_t i = 1; i < at_.size(); ++i) {
      parts += at_[i].part != at_[i - 1].part;
      fans += at_[i].fan != at_[i - 1].fan;
    }
    const auto triangle_of = [](const CornerAt& c) { return c.corner / 3; };
    if (parts == fans) {  // none goes around any other
      for (const CornerAt& c : at_) outside_.surfaces.join(triangle_of(at_.front()), triangle_of(c));
      return;
    }
    // Of each fan, for each part of several fans: which of these is between the fan and the part.
    std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>> places;  // and a triangle of the fan
    std::vector<std::span<const CornerAt>> by_part;
    for (std::size_t i = 0, end = 0; i < at_.size(); i = end) {
      while (end < at_.size() && at_[end].part == at_[i].part) ++end;
      by_part.push_back(std::span(at_).subspan(i, end - i));
    }
    for (const auto& of : by_part)
      for (std::size_t i = 0; i < of.size(); ++i)
        if (i == 0 || of[i].fan != of[i - 1].fan) places.emplace_back(std::vector<std::uint32_t>(), triangle_of(of[i]));
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

  /// Which fan of a part of the link is crossed an odd number of times on the way to it from another part.
  std::uint32_t fan_between(std::uint32_t v, std::span<const CornerAt> from, std::span<const CornerAt> part) const {
    const auto link_triangle = [&](const CornerAt& c) {
      const Row& corners = solid_.simplices[behind_[c.corner / 3]];
      const std::uint32_t at = place_of(v, corners);
      return LinkTriangle{corners[(at + 1) % 4], corners[(at + 2) % 4], corners[(at + 3) % 4]};
    };
    const LinkTriangle begin = link_triangle(from.front()), end = link_triangle(part.front());
    for (std::size_t i = 0, last = 0; i < part.size(); i = last) {
      bool odd = false;
      for (; last < part.size() && part[last].fan == part[i].fan; ++last) {
        const std::uint32_t t = part[last].corner / 3, k = part[last].corner % 3;
        if (arcs_cross(points_, v, begin, end, triangles_[t][(k + 1) % 3], triangles_[t][(k + 2) % 3])) odd = !odd;
      }
      if (odd) return part[i].fan;
    }
    throw meshops::ContractViolation(not_its_boundary);
  }

  using Row = std::array<std::uint32_t, 4>;

  std::span<const Point3> points_;
  const Solid& solid_;
  const std::vector<Triangle>& triangles_;
  const std::vector<std::uint32_t>& behind_;  // tetrahedra
  Outside& outside_;
  meshops::DisjointSets inner_fans_, outer_fans_;
  std::vector<std::uint32_t> seen_;  // of each tetrahedron, the last region that it was in
  std::uint32_t next_region_ = 1;
  std::size_t fans_ = 0, regions_ = 0;
  // Of the point that is looked at.
  std::vector<CornerAt> at_;
  std::vector<std::uint32_t> waiting_;
  meshops::DisjointSets parts_;
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
  outside.edges = triangles.size() * 3 / 2;
  for_each_shared_edge(triangles, points.size(),
                       [&](auto first, auto last) { outside.edges -= static_cast<std::size_t>(last - first) - 1; });

  const Surface glued = glued_outside(points, boundary.surface);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t other : glued.neighbors[t])
      if (other < t) outside.surfaces.join(t, other);
  AtPoints at_points(points, solid, boundary, outside);
  at_points.look_at_all(glued);

  // χ of the boundary, and of the surface just inside of it, along which fans of one region are joined by a tube: that of the open inside is
  // half of the latter, and counts negatively in three dimensions.
  const auto faces = static_cast<std::ptrdiff_t>(triangles.size());
  const auto of_boundary =
      static_cast<std::ptrdiff_t>(outside.points) - static_cast<std::ptrdiff_t>(outside.edges) + faces;
  const auto of_inner = 2 * static_cast<std::ptrdiff_t>(at_points.regions()) -
                        static_cast<std::ptrdiff_t>(at_points.inner_fans()) - faces / 2;
  outside.twice_euler = 2 * of_boundary - of_inner;
  return outside;
}

}  // namespace rbpa::space
