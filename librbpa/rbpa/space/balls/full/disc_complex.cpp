#include "rbpa/space/balls/full/disc_complex.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "rbpa/base/arrays/grouped.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/orthosphere.h"

namespace rbpa::space {

DiscComplex::DiscComplex(std::span<const Point3> centers, std::span<const double> radii,
                         const RegularTriangulation& regular, Steps& step) {
  number_edges(centers, regular.flat, step);
  close_outside(centers.size());
  has_disc_.assign(centers.size(), 1);
  for (const Duplicate& duplicate : regular.duplicates) has_disc_[duplicate.index] = 0;
  for (const std::uint32_t i : regular.hidden) has_disc_[i] = 0;
  decide(centers, radii, step);
}

void DiscComplex::number_edges(std::span<const Point3> centers, std::span<const std::array<std::uint32_t, 4>> flat,
                               Steps& step) {
  struct Side {
    std::array<std::uint32_t, 2> ends;  // ascending
    std::uint32_t triangle, side;
    bool is_reversed;
  };
  std::vector<Side> sides;
  for (const auto& row : flat) {
    step();
    if (row[1] == none) continue;
    if (row[2] == none) {
      sides.push_back({{row[0], row[1]}, none, 0, false});
      continue;
    }
    std::array<std::uint32_t, 3> corners = {row[0], row[1], row[2]};
    if (orientation_along(centers[row[0]], centers[row[1]], centers[row[2]], 2) < 0) std::swap(corners[1], corners[2]);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(triangles_), k, a > b});
    }
    ++triangles_;
  }
  sort(sides, step,
       [](const Side& a, const Side& b) { return std::tie(a.ends, a.is_reversed) < std::tie(b.ends, b.is_reversed); });
  std::vector<std::array<std::uint32_t, 3>> of_triangle(triangles_);
  for (const Side& side : sides) {
    step();
    if (ends_.empty() || ends_.back() != side.ends) {
      ends_.push_back(side.ends);
      face_.resize(2 * ends_.size(), none);
    }
    if (side.triangle == none) continue;
    const auto h = static_cast<std::uint32_t>(2 * (ends_.size() - 1) + (side.is_reversed ? 1 : 0));
    face_[h] = side.triangle;
    of_triangle[side.triangle][side.side] = h;
  }
  before_.assign(face_.size(), none);
  for (const auto& [a, b, c] : of_triangle) {
    before_[a] = c;
    before_[b] = a;
    before_[c] = b;
  }
}

/// Links the halfedges outside of the triangulation. At most two end at a disc: one on the hull, two within a line.
void DiscComplex::close_outside(std::size_t discs) {
  halfedge_.assign(discs, none);
  std::vector<std::array<std::uint32_t, 2>> ending(discs, {none, none});
  for (std::uint32_t h = 0; h < face_.size(); ++h) {
    halfedge_[from(h)] = h;
    if (face_[h] != none) continue;
    auto& [first, second] = ending[to(h)];
    (first == none ? first : second) = h;
  }
  for (std::uint32_t h = 0; h < face_.size(); ++h) {
    if (face_[h] != none) continue;
    const auto [first, second] = ending[from(h)];
    before_[h] = second != none && first == (h ^ 1U) ? second : first;
  }
}

/// Decides which simplices are in the complex.
void DiscComplex::decide(std::span<const Point3> centers, std::span<const double> radii, Steps& step) {
  const auto disc = [&](std::uint32_t i) { return Ball{centers[i], radii[i]}; };
  triangle_.assign(triangles_, out);
  for (std::uint32_t h = 0; h < face_.size(); ++h) {
    step();
    if (face_[h] == none || h > before_[h] || h > before_[before_[h]]) continue;
    const int sign = least_power_sign(disc(from(h)), disc(to(h)), disc(apex(h)));
    triangle_[face_[h]] = sign < 0 ? in : sign == 0 ? point : out;
  }
  has_edge_.assign(ends_.size(), 0);
  meshops::DisjointSets components(centers.size());
  std::vector<std::uint32_t> touching;  // edges of discs that only touch, in a point that no other disc covers
  for (std::uint32_t e = 0; e < ends_.size(); ++e) {
    step();
    const auto [a, b] = ends_[e];
    const auto conflicts = [&, a = a, b = b](std::uint32_t h) {
      return face_[h] != none && is_conflict(disc(a), disc(b), disc(apex(h)));
    };
    const bool has_triangle = has_face(2 * e) || has_face(2 * e + 1);
    const int sign = has_triangle ? -1 : least_power_sign(disc(a), disc(b));
    const bool is_alone = !has_triangle && sign <= 0 && !conflicts(2 * e) && !conflicts(2 * e + 1);
    if (has_triangle || (is_alone && sign < 0)) {
      has_edge_[e] = 1;
      components.join(a, b);
    } else if (is_alone) {
      touching.push_back(e);
    }
    if (is_conflict(disc(a), disc(b))) has_disc_[a] = 0;
    if (is_conflict(disc(b), disc(a))) has_disc_[b] = 0;
  }
  for (const std::uint32_t e : touching)
    if (components.find(ends_[e][0]) == components.find(ends_[e][1])) has_edge_[e] = 1;
  fill_points(step);
  for (std::uint32_t h = 0; h < face_.size(); ++h)
    if (has_edge(h)) has_disc_[from(h)] = 1;
}

/// Returns the regions of the complement: sets of the numbers that region_of() returns.
meshops::DisjointSets DiscComplex::regions(Steps& step) const {
  meshops::DisjointSets regions(triangles_ + 1);
  for (std::uint32_t h = 0; h < face_.size(); h += 2) {
    step();
    if (!has_edge(h)) regions.join(region_of(h), region_of(h + 1));
  }
  return regions;
}

/// Adds the regions of the complement that are single points: all their triangles have the power 0.
void DiscComplex::fill_points(Steps& step) {
  if (std::find(triangle_.begin(), triangle_.end(), point) == triangle_.end()) return;
  meshops::DisjointSets regions = this->regions(step);
  std::vector<std::uint8_t> is_point(triangles_ + 1, 1);
  is_point[regions.find(region_of(none))] = 0;
  for (std::uint32_t t = 0; t < triangles_; ++t)
    if (triangle_[t] != point) is_point[regions.find(t)] = 0;
  for (std::uint32_t t = 0; t < triangles_; ++t)
    if (is_point[regions.find(t)] != 0) triangle_[t] = in;
  for (std::uint32_t e = 0; e < ends_.size(); ++e)
    if (has_face(2 * e)) has_edge_[e] = 1;
}

bool DiscComplex::is_point_after(std::uint32_t h) const {
  do {
    if (face_[h] == none || triangle_[face_[h]] != point) return false;
    h = before_[h] ^ 1U;
  } while (!has_edge(h));
  return true;
}

/// Returns the curves in any order. Sets `lowest` to the lowest disc of the component of each disc, or none.
/// ArcCurve::component is that disc, and `region` a triangle of the region; for the unbounded region, it is the number
/// of triangles.
std::vector<ArcCurve> DiscComplex::traced(std::vector<std::uint32_t>& lowest, Steps& step) const {
  meshops::DisjointSets components(has_disc_.size()), regions = this->regions(step);
  for (std::uint32_t h = 0; h < face_.size(); h += 2) {
    step();
    if (has_edge(h)) components.join(from(h), to(h));
  }
  std::vector<ArcCurve> curves;
  std::vector<std::uint8_t> is_done(face_.size(), 0), is_in_edge(has_disc_.size(), 0);
  for (std::uint32_t start = 0; start < face_.size(); ++start) {
    step();
    if (!has_edge(start)) continue;
    is_in_edge[from(start)] = 1;
    if (has_face(start) || is_done[start] != 0) continue;
    ArcCurve& curve = curves.emplace_back();
    std::uint32_t h = start;
    do {
      step();
      is_done[h] = 1;
      curve.halfedges.push_back(h);
      h = next_around(h) ^ 1U;
    } while (h != start);
    const auto first = std::min_element(
        curve.halfedges.begin(), curve.halfedges.end(),
        [&](std::uint32_t a, std::uint32_t b) { return std::pair(from(a), to(a)) < std::pair(from(b), to(b)); });
    std::rotate(curve.halfedges.begin(), first, curve.halfedges.end());
    curve.disc = from(curve.halfedges.front());
    curve.region = regions.find(region_of(start));
  }
  for (std::uint32_t i = 0; i < has_disc_.size(); ++i) {
    step();
    if (!has_disc(i) || is_in_edge[i] != 0) continue;
    ArcCurve& curve = curves.emplace_back();
    curve.disc = i;
    curve.region = regions.find(region_of(halfedge_[i]));
  }
  lowest.assign(has_disc_.size(), none);
  for (std::uint32_t i = 0; i < has_disc_.size(); ++i)
    if (has_disc(i)) lowest[i] = components.find(i);
  for (ArcCurve& curve : curves) curve.component = lowest[curve.disc];
  const std::uint32_t outside = region_of(none), unbounded = regions.find(outside);
  for (ArcCurve& curve : curves)
    if (curve.region == unbounded) curve.region = outside;
  return curves;
}

std::vector<ArcCurve> DiscComplex::curves(std::vector<std::uint32_t>& component_of, Steps& step) const {
  std::vector<ArcCurve> curves = traced(component_of, step);
  // Walk the tree from the unbounded region: the first curve to reach a component is its outer one.
  const Grouped at_region(curves.size(), triangles_ + 1, [&](std::uint32_t c) { return curves[c].region; }),
      of_component(curves.size(), has_disc_.size(), [&](std::uint32_t c) { return curves[c].component; });
  std::vector<std::uint32_t> reached;  // groups of curves at a region
  std::vector<std::uint8_t> is_reached(of_component.size(), 0);
  for (std::uint32_t c = 0; c < curves.size() && reached.empty(); ++c)
    if (curves[c].region == triangles_) reached.push_back(at_region.number()[c]);
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (const std::uint32_t outer : at_region.items(reached[next])) {
      step();
      const std::uint32_t component = of_component.number()[outer];
      if (std::exchange(is_reached[component], std::uint8_t{1}) != 0) continue;
      curves[outer].is_hole = false;
      for (const std::uint32_t c : of_component.items(component))
        if (c != outer) reached.push_back(at_region.number()[c]);
    }
  sort(curves, step, [&](const ArcCurve& a, const ArcCurve& b) {
    const auto end = [&](const ArcCurve& c) { return c.halfedges.empty() ? none : to(c.halfedges.front()); };
    return std::tuple(a.component, a.is_hole, a.disc, end(a)) < std::tuple(b.component, b.is_hole, b.disc, end(b));
  });
  std::vector<std::uint32_t> number_of(has_disc_.size());  // of each lowest disc
  std::uint32_t number = none, last = none;
  for (ArcCurve& curve : curves) {
    if (curve.component != last) number_of[curve.component] = ++number;
    last = std::exchange(curve.component, number);
  }
  for (std::uint32_t& component : component_of)
    if (component != none) component = number_of[component];
  return curves;
}

}  // namespace rbpa::space
