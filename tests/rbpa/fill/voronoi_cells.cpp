#include "rbpa/fill/voronoi_cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/fill/rings/simple_rings.h"
#include "rbpa/fill/validity.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/shape/measure.h"
#include "support/data_folder.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/read_points.h"
#include "support/sets.h"

TEST_SUITE_BEGIN("fill");

namespace {

using rbpa::Delaunay;
using rbpa::Point;
using rbpa::Polygon;
using rbpa::Ring;
using rbpa::VoronoiCells;
using rbpa_test::Points;

struct CellBoundary {
  Points points;
  std::vector<Polygon> polygons;
};

CellBoundary box_of(const Points& points) {
  const auto box = rbpa::box_around(points);
  return {{box.begin(), box.end()}, {Polygon{.shell = {{0, 1, 2, 3}}}}};
}

double largest_of(const Points& points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

double distance_from(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
  const double along = std::clamp(((p.x - a.x) * (dx / length) + (p.y - a.y) * (dy / length)) / length, 0.0, 1.0);
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

template <typename Visit>
void for_each_edge(const std::vector<Polygon>& polygons, Visit visit) {
  const auto of_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i)
      visit(ring.points[i], ring.points[(i + 1) % ring.points.size()]);
  };
  for (const Polygon& polygon : polygons) {
    of_ring(polygon.shell);
    for (const Ring& hole : polygon.holes) of_ring(hole);
  }
}

/// Returns the points, scaled if squares of `largest` overflow.
Points scaled_down(Points points, double largest) {
  return largest > 0x1p500 ? rbpa_test::scaled(std::move(points), -600) : points;
}

/// Returns why the sides of cells without a cell on their right are not those of valid polygons, "" if they are.
std::string wrong_with_outline(const VoronoiCells& cells, const std::set<std::array<std::uint32_t, 2>>& edges) {
  std::multimap<std::uint32_t, std::uint32_t> next;
  for (const auto& [a, b] : edges)
    if (edges.count({b, a}) == 0) next.emplace(a, b);
  std::vector<Ring> rings;
  while (!next.empty()) {
    std::vector<std::uint32_t> path = {next.begin()->first};
    while (!path.empty()) {
      const auto step = next.find(path.back());
      if (step == next.end()) return "an open side";
      const auto found = std::find(path.begin(), path.end(), step->second);
      if (found == path.end()) {
        path.push_back(step->second);
      } else {
        rings.push_back({{found, path.end()}});
        path.erase(found == path.begin() ? found : found + 1, path.end());
      }
      next.erase(step);
    }
  }
  const rbpa::NestedRings nested = rbpa::nest_rings(cells.points, rings);
  if (nested.meet) return "sides meet";
  const bool turns = std::all_of(nested.place.begin(), nested.place.end(),
                                 [](const auto& place) { return place.is_counter_clockwise != place.is_hole(); });
  return turns ? "" : "a ring turns the wrong way";
}

/// Returns the first violated law of cells, "" when there is none. The laws suffice: rings of valid polygons wind once
/// around the places inside and not around others; the sum over all cells winds as their common boundary does.
std::string wrong_with_cells(VoronoiCells cells, Points points, CellBoundary boundary) {
  if (cells.polygons.size() != cells.of.size()) return "not one point for each polygon";
  if (!std::is_sorted(cells.of.begin(), cells.of.end())) return "not in the order of points";
  if (!std::is_sorted(cells.points.begin(), cells.points.end())) return "corners are not in order";
  if (std::adjacent_find(cells.points.begin(), cells.points.end()) != cells.points.end()) return "equal corners";
  for (std::size_t i = 0; i < cells.polygons.size();) {
    const auto end =
        static_cast<std::size_t>(std::upper_bound(cells.of.begin(), cells.of.end(), cells.of[i]) - cells.of.begin());
    const std::vector<Polygon> cell(cells.polygons.begin() + static_cast<std::ptrdiff_t>(i),
                                    cells.polygons.begin() + static_cast<std::ptrdiff_t>(end));
    if (const auto why = rbpa::why_invalid(cells.points, cell))
      return "cell of " + std::to_string(cells.of[i]) + ": " + *why;
    i = end;
  }
  std::set<std::array<std::uint32_t, 2>> edges;
  bool is_twice = false;
  for_each_edge(cells.polygons, [&](std::uint32_t a, std::uint32_t b) {
    is_twice = !edges.insert({a, b}).second || is_twice;
  });
  if (is_twice) return "an edge has two cells on one side";
  if (const std::string wrong = wrong_with_outline(cells, edges); !wrong.empty()) return "outline: " + wrong;
  const double largest = std::max(largest_of(points), largest_of(boundary.points));
  cells.points = scaled_down(std::move(cells.points), largest);
  points = scaled_down(std::move(points), largest);
  boundary.points = scaled_down(std::move(boundary.points), largest);
  const double ulp = std::max(largest_of(boundary.points) * 0x1p-52, std::numeric_limits<double>::denorm_min());
  rbpa::ExactSum all;
  double length = 0;
  std::size_t outer = 0;
  const std::size_t every = 1 + boundary.points.size() / 200;  // the test is quadratic
  std::string wrong;
  const auto add = [&](rbpa::ExactSum& sum, const Point& a, const Point& b) {
    sum.add_product(a.x, b.y);
    sum.add_product(-a.y, b.x);
  };
  for_each_edge(cells.polygons, [&](std::uint32_t a, std::uint32_t b) {
    add(all, cells.points[a], cells.points[b]);
    if (edges.count({b, a}) != 0 || ++outer % every != 0) return;
    double away = std::numeric_limits<double>::infinity();
    for_each_edge(boundary.polygons, [&](std::uint32_t from, std::uint32_t to) {
      const Point &p = boundary.points[from], &q = boundary.points[to];
      away = std::min(away, std::max(distance_from(cells.points[a], p, q), distance_from(cells.points[b], p, q)));
    });
    if (away > 4 * ulp)
      wrong = "an edge without a cell on its right is " + std::to_string(away / ulp) + " ulp off the boundary";
  });
  if (!wrong.empty()) return wrong;
  for_each_edge(boundary.polygons, [&](std::uint32_t a, std::uint32_t b) {
    const Point &p = boundary.points[a], &q = boundary.points[b];
    length += std::hypot(q.x - p.x, q.y - p.y);
    add(all, q, p);
  });
  if (std::abs(all.rounded(-1)) > 4 * ulp * length) return "areas do not add up";
  if (points.size() > 600) return "";
  for (std::size_t i = 0; i < cells.polygons.size(); ++i)
    for (const std::uint32_t v : cells.polygons[i].shell.points) {
      const auto away = [&](const Point& p) { return std::hypot(p.x - cells.points[v].x, p.y - cells.points[v].y); };
      for (const Point& p : points)
        if (away(points[cells.of[i]]) - away(p) > 8 * ulp) return "a corner is nearer to another point";
    }
  return "";
}

/// Returns whether each cell in a box holds its point, up to the last bits, and each point whose cell vanished is as
/// near to another point.
bool hold_their_points(const VoronoiCells& cells, const Points& points) {
  const double ulp = std::max(largest_of(cells.points) * 0x1p-52, std::numeric_limits<double>::denorm_min());
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    const Point& at = points[p];
    if (std::find(points.begin(), points.end(), at) - points.begin() != static_cast<std::ptrdiff_t>(p)) continue;
    const auto [first, last] = std::equal_range(cells.of.begin(), cells.of.end(), p);
    double least = std::numeric_limits<double>::infinity();
    if (first == last) {
      for (const Point& q : points)
        if (q != at) least = std::min(least, std::hypot(q.x - at.x, q.y - at.y));
      if (!(least <= 8 * ulp)) return false;
      continue;
    }
    const std::vector<Polygon> cell(cells.polygons.begin() + (first - cells.of.begin()),
                                    cells.polygons.begin() + (last - cells.of.begin()));
    bool is_inside = false;
    for_each_edge(cell, [&](std::uint32_t from, std::uint32_t to) {
      const Point &a = cells.points[from], &b = cells.points[to];
      least = std::min(least, distance_from(at, a, b));
      if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * ((at.y - a.y) / (b.y - a.y)))
        is_inside = !is_inside;
    });
    if (!is_inside && least > 8 * ulp) return false;
  }
  return true;
}

std::vector<std::vector<Points>> shapes_of(const VoronoiCells& cells) {
  std::vector<std::vector<Points>> shapes;
  for (const Polygon& polygon : cells.polygons) {
    std::vector<Points>& shape = shapes.emplace_back();
    const auto add = [&](const Ring& ring) {
      for (const std::uint32_t v : shape.emplace_back(), ring.points) shape.back().push_back(cells.points[v]);
    };
    add(polygon.shell);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  std::sort(shapes.begin(), shapes.end());
  return shapes;
}

VoronoiCells cells_in(const Delaunay& delaunay, const CellBoundary& boundary) {
  return rbpa::voronoi_cells(delaunay, boundary.points, boundary.polygons);
}

/// Returns the first violated law of the cells of `points` in a box, in their hull, and in an alpha shape.
std::string wrong_with(const Points& points, std::uint64_t seed) {
  if (points.empty()) return "";
  const Delaunay delaunay(points);
  Points shuffled = points;
  rbpa_test::Random random(seed);
  for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random.below(i)]);
  const Delaunay other(shuffled);
  const double spacing = largest_of(points) / std::sqrt(static_cast<double>(points.size())),
               alpha = spacing > 0 ? 1.5 * spacing : 1;
  const auto complex = rbpa::alpha_complex(points, alpha, {.neighbors = true});
  const CellBoundary shape = {points, rbpa::outline_polygons(points, complex)};
  const std::vector<CellBoundary> boundaries = {
      box_of(points), {points, rbpa::outline_polygons(points, delaunay.triangulation())}, shape};
  for (std::size_t i = 0; i < 3; ++i) {
    const VoronoiCells cells = cells_in(delaunay, boundaries[i]);
    const std::string which = std::array{"box: ", "hull: ", "shape: "}[i];
    if (const std::string wrong = wrong_with_cells(cells, points, boundaries[i]); !wrong.empty()) return which + wrong;
    if (shapes_of(cells_in(other, boundaries[i])) != shapes_of(cells)) return which + "depends on the order of points";
    if (i == 0 && points.size() < 600 && largest_of(points) < 0x1p500 && !hold_their_points(cells, points))
      return "a point is not in its cell";
  }
  return "";
}

/// Returns `count` points with coordinates from 0 to `most` times `unit`, moved by `origin`.
Points lattice_points(std::size_t count, std::uint64_t most, double origin, double unit, rbpa_test::Random& random) {
  Points points;
  const auto coordinate = [&] { return origin + unit * static_cast<double>(random.below(most + 1)); };
  for (std::size_t i = 0; i < count; ++i) points.push_back({coordinate(), coordinate()});
  return points;
}

}  // namespace

TEST_CASE("cells of few points on lattices tile regions with holes on the same lattice, at the last bits as well") {
  rbpa_test::Random random(3);
  std::size_t inserted = 0, holes = 0;
  for (int round = 0; round < 500; ++round) {
    CAPTURE(round);
    const double origin = std::array{0.0, 0x1p52, 0x1p53 - 6, 0x1p52 / 3}[random.below(4)];
    const double unit = std::array{1.0, 0.1, 0.5}[random.below(3)];
    const std::uint64_t most = 2 + random.below(20);
    const Points points = lattice_points(1 + random.below(30), most, origin, unit, random);
    const Points others = lattice_points(3 + random.below(most * most), most, origin, unit, random);
    const double alpha = (1 + 0.1 * static_cast<double>(random.below(most))) * unit;
    const auto complex = rbpa::alpha_complex(others, alpha, {.neighbors = true});
    const CellBoundary boundary = {others, rbpa::outline_polygons(others, complex)};
    holes += rbpa::total(boundary.polygons).holes;
    const VoronoiCells cells = cells_in(Delaunay(points), boundary);
    inserted += cells.inserted;
    CHECK(wrong_with_cells(cells, points, boundary) == "");
    CHECK(wrong_with(points, 4) == "");
  }
  CHECK(inserted > 50);
  CHECK(holes > 50);
}

TEST_CASE("cells of generated sets tile a box, the hull and an alpha shape") {
  for (const auto& set : rbpa_test::generated_sets()) {
    CAPTURE(set.name);
    const Points points = set.make();
    CHECK(wrong_with(points, 1) == "");
  }
}

TEST_CASE("cells of the bundled sets tile a box, the hull and an alpha shape") {
  for (const auto& file : rbpa_test::point_files(rbpa_test::bundled_data())) {
    CAPTURE(file.name);
    Points points = rbpa_test::read_points(file);
    points.resize(std::min<std::size_t>(points.size(), 3000));
    CHECK(wrong_with(points, 2) == "");
  }
}
