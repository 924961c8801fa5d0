// What: the functions of the plane that WebAssembly exports. Points and results are arrays in the memory of
//       WebAssembly.
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "javascript/exports.h"
#include "rbpa/base/alpha_choice.h"
#include "rbpa/base/error.h"
#include "rbpa/base/point.h"
#include "rbpa/fill/voronoi_cells.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/choose_alpha.h"
#include "rbpa/plane/constrained_delaunay.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/plateaus.h"

namespace {

using rbpa::AlphaComplex;
using rbpa::Point;
using rbpa::Triangle;
using rbpa::javascript::completes;
using rbpa::javascript::results;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::span<const Point> points_of(const double* numbers, std::size_t count) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  return {reinterpret_cast<const Point*>(numbers), count};
}
enum class Seen { y_up, y_down };  ///< direction of y for which triangles are counter-clockwise

/// Returns for each side of a triangle, from corner i to the next, the number of its twin, the same side in the
/// triangle beyond, or −1. If y points down, the sides of a triangle are in the opposite order, as the caller swaps its
/// second and third corner.
std::vector<std::int32_t> halfedges_of(const std::vector<Triangle>& triangles, const std::vector<Triangle>& neighbors,
                                       Seen seen) {
  std::vector<std::int32_t> halfedges(3 * triangles.size());
  const auto side = [seen](std::size_t t, std::size_t i) { return 3 * t + (seen == Seen::y_up ? i : 2 - i); };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t here = side(t, i);
      const std::uint32_t beyond = neighbors[t][(i + 2) % 3];
      if (beyond == AlphaComplex::none) halfedges[here] = -1;
      if (beyond == AlphaComplex::none || beyond < t) continue;  // the lower-numbered triangle sets both entries
      const Triangle& other = triangles[beyond];
      const std::uint32_t end = triangles[t][(i + 1) % 3];
      const std::size_t there = side(beyond, other[1] == end ? 1U : other[2] == end ? 2U : 0U);
      halfedges[here] = static_cast<std::int32_t>(there);
      halfedges[there] = static_cast<std::int32_t>(here);
    }
  return halfedges;
}

AlphaComplex triangulated(std::span<const Point> points, double alpha) {
  return rbpa::alpha_complex(points, alpha, {.neighbors = true, .boundary = true});
}

/// Returns the choice that `rule` names; if `rule` is null, the choice of the radius `radius`.
rbpa::AlphaChoice choice_of(const char* rule, double radius) {
  if (!rule) return {.radius = radius};
  if (const std::optional<rbpa::AlphaChoice> choice = rbpa::parse_alpha_rule(rule)) return *choice;
  throw rbpa::InvalidInput("alpha: found '" + std::string(rule) + "', expected " + std::string(rbpa::expected_alpha));
}

/// Returns the radius that `choice` has or chooses; 0 if the points have no triangle at any radius.
double chosen(const rbpa::AlphaChoice& choice, const rbpa::Delaunay& delaunay) {
  return rbpa::choose_alpha(choice, delaunay).alpha.value_or(0);
}

void add_triangulation(AlphaComplex made) {
  results.add(halfedges_of(made.triangles, made.neighbors, Seen::y_up));
  results.add(std::move(made.triangles));
  results.add(std::move(made.neighbors));
  results.add(std::move(made.boundary));
  results.add(std::move(made.isolated));
  results.add(std::move(made.duplicates));
}

/// Adds six arrays to the results: the first ring of each polygon, and the first point of each ring, each with the end;
/// the points of all rings; the areas and the perimeters of polygons; both totals.
void add_polygons(const std::vector<rbpa::Polygon>& polygons) {
  std::vector<std::uint32_t> first_ring = {0}, first_point = {0}, points;
  std::vector<double> area, perimeter;
  const auto add_ring = [&](const rbpa::Ring& ring) {
    points.insert(points.end(), ring.points.begin(), ring.points.end());
    first_point.push_back(static_cast<std::uint32_t>(points.size()));
  };
  for (const rbpa::Polygon& polygon : polygons) {
    add_ring(polygon.shell);
    for (const rbpa::Ring& hole : polygon.holes) add_ring(hole);
    first_ring.push_back(static_cast<std::uint32_t>(first_point.size() - 1));
    area.push_back(polygon.area);
    perimeter.push_back(polygon.perimeter);
  }
  const rbpa::PolygonTotals totals = rbpa::total(polygons);
  results.add(std::move(first_ring));
  results.add(std::move(first_point));
  results.add(std::move(points));
  results.add(std::move(area));
  results.add(std::move(perimeter));
  results.add(std::vector<double>{totals.area, totals.perimeter});
}

}  // namespace

RBPA_EXPORT bool rbpa_alpha_complex(const double* points, std::size_t count, double alpha) {
  return completes([&] { add_triangulation(triangulated(points_of(points, count), alpha)); });
}

/// Computes the members of Delaunator: triangles that are counter-clockwise if y points down; the twin of each side of
/// a triangle; the sides of the hull.
RBPA_EXPORT bool rbpa_delaunator(const double* points, std::size_t count) {
  return completes([&] {
    AlphaComplex made = triangulated(points_of(points, count), infinity);
    std::vector<std::int32_t> halfedges = halfedges_of(made.triangles, made.neighbors, Seen::y_down);
    for (Triangle& t : made.triangles) std::swap(t[1], t[2]);
    results.add(std::move(made.triangles));
    results.add(std::move(halfedges));
    results.add(std::move(made.boundary));
  });
}

/// Computes an alpha shape. `rule` is null if `radius` is the given radius. The first result is the radius; 0 if the
/// rule finds no radius.
RBPA_EXPORT bool rbpa_alpha_shape(const double* points, const char* rule, std::size_t count, double radius,
                                  double min_hole_area, double min_part_area) {
  return completes([&] {
    const auto input = points_of(points, count);
    const rbpa::AlphaChoice choice = choice_of(rule, radius);
    AlphaComplex made = triangulated(input, choice.radius);
    double alpha = choice.radius;
    if (choice.rule != rbpa::AlphaRule::given) {
      alpha = chosen(choice, rbpa::Delaunay(made, input, {}, "alphaShape"));
      if (alpha > 0) made = triangulated(input, alpha);
    }
    const auto polygons =
        rbpa::outline_polygons(input, made, {.min_hole_area = min_hole_area, .min_part_area = min_part_area});
    results.add(std::vector<double>{alpha});
    add_triangulation(std::move(made));
    add_polygons(polygons);
  });
}

RBPA_EXPORT bool rbpa_filtration(const double* points, std::size_t count) {
  return completes([&] {
    const auto input = points_of(points, count);
    const AlphaComplex made = triangulated(input, infinity);
    const rbpa::Delaunay delaunay(made, input, {}, "filtration");
    const rbpa::Filtration filtration = rbpa::filtration(delaunay);
    std::vector<double> alpha, area;
    std::array<std::vector<std::uint32_t>, 5> counts;
    for (const rbpa::FiltrationStep& step : filtration.steps) {
      alpha.push_back(step.alpha);
      area.push_back(step.area);
      const std::array<std::size_t, 5> of_step = {step.triangles, step.solid_components, step.components, step.holes,
                                                  step.covered};
      for (std::size_t i = 0; i < counts.size(); ++i) counts[i].push_back(static_cast<std::uint32_t>(of_step[i]));
    }
    std::vector<double> plateaus;  // from, to, ratio, alpha, whether structured, whether long
    for (const rbpa::Plateau& p : rbpa::plateaus(delaunay, filtration))
      for (const double number : {p.from, p.to.value_or(infinity), p.ratio, p.alpha,
                                  p.kind == rbpa::PlateauKind::structured ? 1.0 : 0.0, p.is_long ? 1.0 : 0.0})
        plateaus.push_back(number);
    results.add(std::move(alpha));
    for (auto& count_of_steps : counts) results.add(std::move(count_of_steps));
    results.add(std::move(area));
    results.add(std::vector<double>{chosen({.rule = rbpa::AlphaRule::automatic}, delaunay),
                                    chosen({.rule = rbpa::AlphaRule::least}, delaunay)});
    results.add(std::move(plateaus));
  });
}

/// Computes the Voronoi cells within a box, its least x, least y, greatest x and greatest y; if `box` is null, within a
/// box around the points. The results are the corners, the polygons, and for each polygon the point of its cell.
RBPA_EXPORT bool rbpa_voronoi(const double* points, const double* box, std::size_t count) {
  return completes([&] {
    const auto input = points_of(points, count);
    std::vector<Point> corners;
    if (box != nullptr) {
      corners = {{box[0], box[1]}, {box[2], box[1]}, {box[2], box[3]}, {box[0], box[3]}};
    } else if (!input.empty()) {
      const auto around = rbpa::box_around(input);
      corners.assign(around.begin(), around.end());
    }
    std::vector<rbpa::Polygon> boundary;
    if (!corners.empty()) boundary.push_back({.shell = {{0, 1, 2, 3}}});
    rbpa::VoronoiCells cells = rbpa::voronoi_cells(rbpa::Delaunay(input), corners, boundary);
    results.add(std::move(cells.points));
    results.add(std::move(cells.of));
    add_polygons(cells.polygons);
  });
}

/// Computes a constrained Delaunay triangulation. `segments` has two indices of points for each of `segment_count`
/// segments; the caller has checked them.
RBPA_EXPORT bool rbpa_constrained_delaunay(const double* points, const double* segments, std::size_t count,
                                           double segment_count, double split_crossings) {
  return completes([&] {
    std::vector<rbpa::Segment> ends(static_cast<std::size_t>(segment_count));
    for (std::size_t i = 0; i < ends.size(); ++i)
      ends[i] = {static_cast<std::uint32_t>(segments[2 * i]), static_cast<std::uint32_t>(segments[2 * i + 1])};
    rbpa::ConstrainedDelaunay made =
        rbpa::constrained_delaunay(points_of(points, count), ends, {.split_crossings = split_crossings != 0});
    rbpa::SegmentRegions found = rbpa::regions(made);
    results.add(std::move(made.points));
    results.add(std::move(made.crossed));
    results.add(std::vector<std::uint32_t>(made.constrained.begin(), made.constrained.end()));
    results.add(std::move(made.edges));
    results.add(std::move(found.region));
    results.add(std::vector<std::uint32_t>(found.is_inside.begin(), found.is_inside.end()));
    results.add(halfedges_of(made.triangles, made.neighbors, Seen::y_up));
    results.add(std::move(made.triangles));
    results.add(std::move(made.neighbors));
    results.add(std::move(made.boundary));
    results.add(std::move(made.duplicates));
  });
}
