#include "fill/laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "meshops/core/validate.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/fill/filling_mesh.h"
#include "support/exact.h"

namespace rbpa_test {
namespace {

using rbpa::Point;
using rbpa::Polygon;
using rbpa::Ring;
using Sides = std::set<std::pair<std::uint32_t, std::uint32_t>>;

template <typename Visit>
void for_each_ring(std::span<const Polygon> polygons, Visit visit) {
  for (const Polygon& polygon : polygons) {
    visit(polygon.shell);
    for (const Ring& hole : polygon.holes) visit(hole);
  }
}

void add_twice(rbpa::ExactSum& sum, const Point& a, const Point& b) {
  sum.add_product(a.x, b.y);
  sum.add_product(-a.y, b.x);
}

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Returns the ring of the input as it must be passed: consecutive vertices at one place are merged.
Points without_repeated(const Ring& ring, std::span<const Point> points) {
  Points places;
  for (const std::uint32_t i : ring.points)
    if (places.empty() || places.back() != points[i]) places.push_back(points[i]);
  while (places.size() > 1 && places.back() == places.front()) places.pop_back();
  return places;
}

bool is_exactly_between(const Point& p, const Point& a, const Point& b) {
  return exact::orientation(a, b, p) == 0 && std::min(a, b) < p && p < std::max(a, b);
}

/// Returns whether the ring of input points `passed` goes around `expected`, with only vertices that lie exactly on its
/// edges in between. Both begin at the same place.
bool goes_round(const Points& passed, const Points& expected) {
  std::size_t next = 0;
  for (const Point& p : passed) {
    if (next < expected.size() && p == expected[next]) {
      ++next;
      continue;
    }
    if (next == 0 || !is_exactly_between(p, expected[next - 1], expected[next % expected.size()])) return false;
  }
  return next == expected.size();
}

/// Checks `cut`, the ring with new points on its edges, which may have the other direction and begin elsewhere.
std::string wrong_with_ring(const Ring& cut, const Ring& input, std::span<const Point> points, std::size_t given,
                            bool keeps) {
  Points passed;
  for (const std::uint32_t i : cut.points)
    if (i < given) passed.push_back(points[i]);
  if (std::set<std::uint32_t>(cut.points.begin(), cut.points.end()).size() != cut.points.size())
    return "a ring passes a point twice";
  Points expected = without_repeated(input, points);
  if (passed.empty() || expected.empty()) return passed.empty() && expected.empty() ? "" : "a ring has been lost";
  bool goes = false;
  for (int turned = 0; turned < 2 && !goes; ++turned) {
    std::rotate(passed.begin(), std::find(passed.begin(), passed.end(), expected.front()), passed.end());
    goes = goes_round(passed, expected);
    std::reverse(expected.begin(), expected.end());
  }
  if (!goes) return "a ring does not pass the points of the input in their order";
  if (keeps && passed.size() != cut.points.size()) return "an edge was cut that was to be kept";
  // Goes around once, from corner to corner.
  const std::size_t n = cut.points.size();
  const std::size_t start = static_cast<std::size_t>(
      std::find_if(cut.points.begin(), cut.points.end(), [&](std::uint32_t i) { return i < given; }) -
      cut.points.begin());
  for (std::size_t i = 0; i < n;) {
    const Point& a = points[cut.points[(start + i) % n]];
    std::size_t j = i + 1;
    while (cut.points[(start + j) % n] >= given) ++j;
    const Point& b = points[cut.points[(start + j) % n]];
    const double far = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    for (std::size_t k = i + 1; k < j; ++k) {
      const Point& p = points[cut.points[(start + k) % n]];
      const double off = std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / distance(a, b);
      if (!(off <= 4 * 0x1p-53 * far)) return "a point that was put on an edge is not on it";
    }
    i = j;
  }
  return "";
}

/// Checks that arrays and mesh are sound and agree.
std::string wrong_with_mesh(const rbpa::Filling& filling) {
  const auto& triangles = filling.triangles;
  require_linked(filling, filling.points.size());
  const auto& [mesh, point_of_vertex] = rbpa::filling_mesh(filling);
  if (const auto defects = meshops::validate(mesh); !defects.empty()) return describe(defects.front());
  if (mesh.n_faces() != triangles.size() || mesh.n_vertices() != point_of_vertex.size())
    return "the mesh has other elements than the arrays";
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    Triangle corners{};
    std::size_t k = 0;
    for (const auto v : mesh.fv_ccw_range(rbpa::Mesh::FaceHandle(static_cast<int>(f))))
      corners[k++] = point_of_vertex[static_cast<std::size_t>(v.idx())];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (corners != triangles[f]) return "a face of the mesh is not the triangle of its number";
    for (const auto h : mesh.fh_ccw_range(rbpa::Mesh::FaceHandle(static_cast<int>(f)))) {
      const std::uint32_t end = point_of_vertex[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())];
      const auto at = std::find(corners.begin(), corners.end(), end) - corners.begin();
      const auto beyond = mesh.face_handle(mesh.opposite_halfedge_handle(h));
      if (filling.neighbors[f][static_cast<std::size_t>(at + 1) % 3] != static_cast<std::uint32_t>(beyond.idx()))
        return "the mesh is not glued as its triangles are";
    }
  }
  for (std::size_t i = 0; i < point_of_vertex.size(); ++i) {
    const std::uint32_t under = point_of_vertex[i];
    if (i < filling.points.size() && under != i) return "a vertex does not stand on the point of its number";
    const auto& p = mesh.point(rbpa::Mesh::VertexHandle(static_cast<int>(i)));
    if (Point{p[0], p[1]} != filling.points[under] || p[2] != 0)
      return "a vertex of the mesh is not where its point is";
  }
  return "";
}

}  // namespace

std::string wrong_with_filling(const rbpa::Filling& filling, std::span<const Point> points,
                               std::span<const Polygon> polygons, bool keeps_boundary) {
  const auto& triangles = filling.triangles;
  if (!std::is_sorted(triangles.begin(), triangles.end())) return "triangles are out of order";
  rbpa::ExactSum area, enclosed;
  Sides open;
  std::vector<bool> used(filling.points.size(), false);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    if (a > b || a > c) return "a triangle does not begin with its least point";
    if (exact::orientation(filling.points[a], filling.points[b], filling.points[c]) <= 0)
      return "triangle " + std::to_string(t) + " is not counter-clockwise";
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[t][k], to = triangles[t][(k + 1) % 3];
      used[from] = true;
      add_twice(area, filling.points[from], filling.points[to]);
      if (filling.neighbors[t][(k + 2) % 3] == rbpa::TriangleArrays::none) open.insert({from, to});
    }
  }
  if (std::string wrong = wrong_with_mesh(filling); !wrong.empty()) return wrong;
  if (!std::equal(points.begin(), points.end(), filling.points.begin())) return "a point of the input has moved";
  for (std::size_t i = points.size(); i < used.size(); ++i)
    if (!used[i]) return "a new point is in no triangle";

  Sides edges;
  std::size_t new_on_boundary = 0;
  bool an_inner_one = false;
  for_each_ring(filling.polygons, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const std::uint32_t from = ring.points[i], to = ring.points[(i + 1) % ring.points.size()];
      edges.insert({from, to});
      add_twice(enclosed, filling.points[from], filling.points[to]);
      new_on_boundary += from >= points.size();
      an_inner_one = an_inner_one || from >= filling.boundary_points;
    }
  });
  if (edges != open) return "the boundary of the triangles is not that of the polygons";
  if (an_inner_one) return "an inner point is on a ring";
  if (new_on_boundary != filling.boundary_points - points.size()) return "points on the boundary are miscounted";
  if (area.digits() != enclosed.digits()) return "the areas of the triangles do not add up to that of the polygons";
  if (filling.polygons.size() != polygons.size()) return "there are other polygons than in the input";
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const Polygon &cut = filling.polygons[i], &input = polygons[i];
    if (cut.holes.size() != input.holes.size()) return "there are other holes than in the input";
    std::string wrong = wrong_with_ring(cut.shell, input.shell, filling.points, points.size(), keeps_boundary);
    for (std::size_t h = 0; h < input.holes.size() && wrong.empty(); ++h)
      wrong = wrong_with_ring(cut.holes[h], input.holes[h], filling.points, points.size(), keeps_boundary);
    if (!wrong.empty()) return wrong;
  }
  return "";
}

namespace {

/// Returns one group as if it had been filled alone, with its neighbors found here.
rbpa::Filling alone(const rbpa::Filling& filling, std::size_t group, std::size_t given,
                    std::span<const Polygon> polygons) {
  rbpa::Filling part;
  std::vector<bool> used(filling.points.size(), false);
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    if (filling.groups[t] == group)
      for (const std::uint32_t i : filling.triangles[t]) used[i] = true;
  std::vector<std::uint32_t> number(filling.points.size(), rbpa::TriangleArrays::none);
  for (std::size_t i = 0; i < filling.points.size(); ++i) {
    if (i >= given && !used[i]) continue;
    number[i] = static_cast<std::uint32_t>(part.points.size());
    part.points.push_back(filling.points[i]);
    part.boundary_points += i < filling.boundary_points;
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> left;  // for each directed side
  for (std::size_t t = 0; t < filling.triangles.size(); ++t) {
    if (filling.groups[t] != group) continue;
    auto triangle = filling.triangles[t];
    for (std::uint32_t& i : triangle) i = number[i];
    for (std::size_t k = 0; k < 3; ++k)
      left[{triangle[k], triangle[(k + 1) % 3]}] = static_cast<std::uint32_t>(part.triangles.size());
    part.triangles.push_back(triangle);
  }
  for (const auto& triangle : part.triangles) {
    auto& neighbors = part.neighbors.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto beyond = left.find({triangle[(k + 1) % 3], triangle[k]});
      neighbors[(k + 2) % 3] = beyond == left.end() ? rbpa::TriangleArrays::none : beyond->second;
    }
  }
  part.polygons.assign(polygons.begin(), polygons.end());
  for (Polygon& polygon : part.polygons) {
    for (std::uint32_t& i : polygon.shell.points) i = number[i];
    for (Ring& hole : polygon.holes)
      for (std::uint32_t& i : hole.points) i = number[i];
  }
  return part;
}

std::string wrong_with_neighbors_of_groups(const rbpa::Filling& filling) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> left;
  const auto side = [&](std::size_t t, std::size_t k) {
    return std::pair(filling.triangles[t][(k + 1) % 3], filling.triangles[t][(k + 2) % 3]);
  };
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) left[side(t, k)].push_back(t);
  std::set<std::size_t> overlapping;
  for (const auto& [ends, triangles] : left)
    if (triangles.size() > 1)
      for (const std::size_t t : triangles) overlapping.insert(filling.groups[t]);
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [from, to] = side(t, k);
      std::uint32_t expected = rbpa::TriangleArrays::none;
      if (const auto beyond = left.find({to, from}); beyond != left.end())
        for (const std::size_t other : beyond->second)
          if (filling.groups[other] == filling.groups[t] ||
              (!overlapping.contains(filling.groups[other]) && !overlapping.contains(filling.groups[t])))
            expected = static_cast<std::uint32_t>(other);
      if (filling.neighbors[t][k] != expected) return "triangle " + std::to_string(t) + " has another neighbor";
    }
  return "";
}

}  // namespace

std::string wrong_with_groups(const rbpa::Filling& filling, std::span<const Point> points,
                              std::span<const Polygon> polygons, std::span<const std::size_t> groups,
                              bool keeps_boundary) {
  if (filling.groups.size() != filling.triangles.size()) return "not every triangle has a group";
  if (std::string wrong = wrong_with_mesh(filling); !wrong.empty()) return wrong;
  if (std::string wrong = wrong_with_neighbors_of_groups(filling); !wrong.empty()) return wrong;
  if (filling.polygons.size() != polygons.size()) return "there are other polygons than in the input";
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::size_t first = groups[g], last = g + 1 < groups.size() ? groups[g + 1] : polygons.size();
    const rbpa::Filling part =
        alone(filling, g, points.size(), std::span(filling.polygons).subspan(first, last - first));
    const std::string wrong = wrong_with_filling(part, points, polygons.subspan(first, last - first), keeps_boundary);
    if (!wrong.empty()) return "group " + std::to_string(g) + ": " + wrong;
  }
  return "";
}

double wanted_size(const Point& p, const rbpa::FillOptions& options, std::span<const Point> points,
                   std::span<const Polygon> polygons) {
  const double grade = options.grade.value_or(rbpa::FillOptions::default_grade);
  double wanted = options.size;
  for (const rbpa::SizeAt& size : options.sizes) wanted = std::min(wanted, size.size + grade * distance(p, size.at));
  if (options.grade)
    for_each_ring(polygons, [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const Point &a = points[ring.points[i]], &b = points[ring.points[(i + 1) % ring.points.size()]];
        const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        wanted = std::min(wanted, distance(a, b) + grade * distance(p, middle));
      }
    });
  return wanted;
}

FillQuality quality_of(const rbpa::Filling& filling, const rbpa::FillOptions& options, std::span<const Point> points,
                       std::span<const Polygon> polygons) {
  const auto angle = [](const Point& at, const Point& from, const Point& to) {
    const double ux = from.x - at.x, uy = from.y - at.y, vx = to.x - at.x, vy = to.y - at.y;
    const double turn = std::atan2(ux * vy - uy * vx, ux * vx + uy * vy) * 180 / 3.14159265358979323846;
    return turn < 0 ? turn + 360 : turn;
  };
  Points sharp;
  for_each_ring(filling.polygons, [&](const Ring& ring) {
    const std::size_t n = ring.points.size();
    const auto at = [&](std::size_t i) { return filling.points[ring.points[i % n]]; };
    for (std::size_t i = 0; i < n; ++i)
      if (angle(at(i), at(i + 1), at(i + n - 1)) < 60) sharp.push_back(at(i));
  });
  FillQuality quality;
  for (std::size_t t = 0; t < filling.triangles.size(); ++t) {
    std::array<Point, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = filling.points[filling.triangles[t][k]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = filling.neighbors[t][(k + 2) % 3];
      if (other != rbpa::TriangleArrays::none && other < t) continue;
      const Point &a = corner[k], &b = corner[(k + 1) % 3];
      const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
      const double share = distance(a, b) / wanted_size(middle, options, points, polygons);
      ++quality.edges;
      quality.edges_in_range += share >= 0.6 && share <= 1.6;
    }
    const auto is_near = [&](const Point& p) {
      return std::any_of(corner.begin(), corner.end(),
                         [&](const Point& c) { return distance(c, p) < 2 * options.size; });
    };
    if (std::any_of(sharp.begin(), sharp.end(), is_near)) continue;
    double least = 180;
    for (std::size_t k = 0; k < 3; ++k)
      least = std::min(least, angle(corner[k], corner[(k + 1) % 3], corner[(k + 2) % 3]));
    ++quality.triangles;
    quality.with_20_degrees += least >= 20;
  }
  return quality;
}

}  // namespace rbpa_test
