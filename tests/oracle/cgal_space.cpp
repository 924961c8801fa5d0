#include "oracle/cgal_space.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <map>
#include <utility>

namespace rbpa_test {
namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
template <typename K>
using VertexWithIndex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, K>;

/// Returns the distinct points with the lowest index of each.
template <typename K>
std::vector<std::pair<typename K::Point_3, std::uint32_t>> distinct(std::span<const rbpa::Point3> points) {
  std::map<rbpa::Point3, std::uint32_t> lowest;
  for (std::uint32_t i = 0; i < points.size(); ++i) lowest.emplace(points[i], i);
  std::vector<std::pair<typename K::Point_3, std::uint32_t>> result;
  for (const auto& [p, i] : lowest) result.push_back({{p.x, p.y, p.z}, i});
  return result;
}

Triangle from_least(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The closed alpha complex, limited to triangles and tetrahedra.
class AlphaComplex {
 public:
  using Triangulation = CGAL::Delaunay_triangulation_3<
      Inexact, CGAL::Triangulation_data_structure_3<VertexWithIndex<Inexact>,
                                                    CGAL::Delaunay_triangulation_cell_base_3<Inexact>>>;
  using Cell = Triangulation::Cell_handle;
  using Facet = Triangulation::Facet;  // facet of a cell, across from its vertex i

  AlphaComplex(std::span<const rbpa::Point3> points, double radius) : square_(Exact::FT(radius) * Exact::FT(radius)) {
    const auto sites = distinct<Inexact>(points);
    delaunay_.insert(sites.begin(), sites.end());
  }

  /// Side of a triangle on which the ball lies. In the plane, the first or the second.
  struct Side {
    Cell cell;
    int i;
    bool first;
  };

  /// Returns all exposed sides, and the sides to which they are glued.
  ExposedByCgal exposed() const {
    std::map<Triangle, Triangle> at;  // for each exposed triangle, the three across from its corners
    const auto add = [&](const Side& side) {
      const Triangle t = corners(side);
      std::array<Triangle, 3> mates;
      for (int k = 0; k < 3; ++k) mates[static_cast<std::size_t>(k)] = corners(rolled(side, t, k));
      found_.push_back({t, mates});
    };
    found_.clear();
    if (delaunay_.dimension() == 3) {
      for (const Facet& f : delaunay_.finite_facets()) {
        if (!has(f)) continue;
        const Facet mirror = delaunay_.mirror_facet(f);
        if (!has(f.first)) add({f.first, f.second, true});
        if (!has(mirror.first)) add({mirror.first, mirror.second, true});
      }
    } else if (delaunay_.dimension() == 2) {
      for (const Facet& f : delaunay_.finite_facets())
        if (fits(f)) {
          add({f.first, 3, true});
          add({f.first, 3, false});
        }
    }
    std::sort(found_.begin(), found_.end());
    ExposedByCgal result;
    const auto number = [&](const Triangle& t) {
      const auto place = std::lower_bound(found_.begin(), found_.end(), t,
                                          [](const Found& f, const Triangle& wanted) { return f.triangle < wanted; });
      return static_cast<std::uint32_t>(place - found_.begin());
    };
    for (const Found& f : found_) {
      result.triangles.push_back(f.triangle);
      result.neighbors.push_back({number(f.mates[0]), number(f.mates[1]), number(f.mates[2])});
    }
    return result;
  }

 private:
  struct Found {
    Triangle triangle;
    std::array<Triangle, 3> mates;
    auto operator<=>(const Found&) const = default;
  };

  static Exact::Point_3 exact(const Inexact::Point_3& p) { return {p.x(), p.y(), p.z()}; }
  Exact::Point_3 at(Cell c, int i) const { return exact(c->vertex(i)->point()); }

  /// Returns whether the circumradius of the facet is at most the radius.
  bool fits(const Facet& f) const {
    const auto& [c, i] = f;
    return compare_(at(c, (i + 1) & 3), at(c, (i + 2) & 3), at(c, (i + 3) & 3), square_) != CGAL::LARGER;
  }
  bool has(Cell c) const {
    return !delaunay_.is_infinite(c) && compare_(at(c, 0), at(c, 1), at(c, 2), at(c, 3), square_) != CGAL::LARGER;
  }
  bool has(const Facet& f) const {
    if (delaunay_.is_infinite(f)) return false;
    return has(f.first) || has(delaunay_.mirror_facet(f).first) || (fits(f) && delaunay_.is_Gabriel(f));
  }

  /// Returns the corners, counter-clockwise as seen from the side.
  Triangle corners(const Side& s) const {
    const auto index = [&](int j) { return s.cell->vertex(j)->info(); };
    if (delaunay_.dimension() == 2) {
      const Triangle t = s.first ? Triangle{index(0), index(1), index(2)} : Triangle{index(0), index(2), index(1)};
      return from_least(t);
    }
    std::array<int, 3> j = {(s.i + 1) & 3, (s.i + 2) & 3, (s.i + 3) & 3};
    const auto point = [&](int k) { return s.cell->vertex(k)->point(); };
    Facet behind(s.cell, s.i);
    bool above = true;
    if (delaunay_.is_infinite(s.cell)) {
      behind = delaunay_.mirror_facet(behind);
      above = false;
    }
    const auto apex = behind.first->vertex(behind.second)->point();
    if ((CGAL::orientation(point(j[0]), point(j[1]), point(j[2]), apex) == CGAL::POSITIVE) != above)
      std::swap(j[0], j[1]);
    return from_least({index(j[0]), index(j[1]), index(j[2])});
  }

  /// Returns the side to which the ball rolls around the edge across from corner k, through the outside of the complex.
  Side rolled(const Side& s, const Triangle& t, int k) const {
    int apex = 0;
    while (delaunay_.is_infinite(s.cell->vertex(apex)) || apex == s.i ||
           s.cell->vertex(apex)->info() != t[static_cast<std::size_t>(k)])
      ++apex;
    if (delaunay_.dimension() == 2) {
      const Cell next = s.cell->neighbor(apex);
      if (delaunay_.is_infinite(next, 3) || !fits({next, 3})) return {s.cell, 3, !s.first};
      // The ball is on the same side if the common edge runs the other way.
      const std::uint32_t from = t[static_cast<std::size_t>((k + 1) % 3)],
                          to = t[static_cast<std::size_t>((k + 2) % 3)];
      for (const bool first : {true, false}) {
        const Triangle u = corners({next, 3, first});
        for (std::size_t i = 0; i < 3; ++i)
          if (u[i] == to && u[(i + 1) % 3] == from) return {next, 3, first};
      }
    }
    Facet entered(s.cell, s.i);  // with the cell that contains the ball
    int other = apex;            // the vertex of that facet off the edge
    while (true) {
      const auto& [c, i] = entered;
      const Facet wall(c, other);  // also has the edge
      if (has(wall)) return {c, other, true};
      const auto beyond = c->vertex(i);  // on the wall, off the edge
      entered = delaunay_.mirror_facet(wall);
      other = entered.first->index(beyond);
    }
  }

  Triangulation delaunay_;
  Exact::FT square_;
  Exact::Compare_squared_radius_3 compare_ = Exact().compare_squared_radius_3_object();
  mutable std::vector<Found> found_;
};

}  // namespace

ExposedByCgal exposed_by_delaunay(std::span<const rbpa::Point3> points, double radius) {
  return AlphaComplex(points, radius).exposed();
}

ExposedByCgal agreeing(const ExposedByCgal& exposed, std::span<const rbpa::Point3> points,
                       std::span<const rbpa::Point3> normals) {
  std::map<rbpa::Point3, std::vector<std::uint32_t>> at;
  for (std::uint32_t i = 0; i < points.size(); ++i) at[points[i]].push_back(i);
  const auto point = [&](std::uint32_t i) { return Exact::Point_3(points[i].x, points[i].y, points[i].z); };
  const auto agrees = [&](const Triangle& t) {
    const Exact::Point_3 a = point(t[0]);
    const Exact::Vector_3 normal = CGAL::cross_product(point(t[1]) - a, point(t[2]) - a);
    for (const std::uint32_t corner : t)
      for (const std::uint32_t i : at[points[corner]])
        if (normal * Exact::Vector_3(normals[i].x, normals[i].y, normals[i].z) <= 0) return false;
    return true;
  };
  ExposedByCgal result;
  std::vector<std::uint32_t> number;
  for (const Triangle& t : exposed.triangles) {
    number.push_back(agrees(t) ? static_cast<std::uint32_t>(result.triangles.size()) : ExposedByCgal::none);
    if (number.back() != ExposedByCgal::none) result.triangles.push_back(t);
  }
  for (std::size_t t = 0; t < number.size(); ++t)
    if (number[t] != ExposedByCgal::none) {
      Triangle across = exposed.neighbors[t];
      for (std::uint32_t& other : across) other = number[other];
      result.neighbors.push_back(across);
    }
  return result;
}

std::vector<Triangle> exposed_by_alpha_shape(std::span<const rbpa::Point3> points, double radius) {
  using Vertex = CGAL::Fixed_alpha_shape_vertex_base_3<Exact, VertexWithIndex<Exact>>;
  using Triangulation = CGAL::Delaunay_triangulation_3<
      Exact, CGAL::Triangulation_data_structure_3<Vertex, CGAL::Fixed_alpha_shape_cell_base_3<Exact>>>;
  using Shape = CGAL::Fixed_alpha_shape_3<Triangulation>;
  const auto sites = distinct<Exact>(points);
  Triangulation delaunay;
  delaunay.insert(sites.begin(), sites.end());
  if (delaunay.dimension() < 3) return {};
  Shape shape(delaunay, Exact::FT(radius) * Exact::FT(radius));
  std::vector<Triangle> found;
  for (Shape::Facet f : shape.finite_facets()) {
    const auto type = shape.classify(f);
    if (type != Shape::REGULAR && type != Shape::SINGULAR) continue;
    // Counter-clockwise as seen from the apex of the cell.
    if (shape.is_infinite(f.first)) f = shape.mirror_facet(f);
    const auto point = [&](int j) { return f.first->vertex(j & 3)->point(); };
    const auto index = [&](int j) { return f.first->vertex(j & 3)->info(); };
    const int i = f.second;
    Triangle above = {index(i + 1), index(i + 2), index(i + 3)};
    if (CGAL::orientation(point(i + 1), point(i + 2), point(i + 3), point(i)) == CGAL::NEGATIVE)
      std::swap(above[1], above[2]);
    const Triangle below = {above[0], above[2], above[1]};
    if (type == Shape::SINGULAR || shape.classify(f.first) == Shape::EXTERIOR) found.push_back(above);
    if (type == Shape::SINGULAR || shape.classify(f.first) == Shape::INTERIOR) found.push_back(below);
  }
  return canonical(found);
}

}  // namespace rbpa_test
