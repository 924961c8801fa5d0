#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "drawings/caption.h"
#include "drawings/drawn_complex.h"
#include "drawings/figures.h"
#include "drawings/random.h"
#include "drawings/sheet.h"
#include "io/cloud/images.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/persistence.h"
#include "rbpa/plane/topology.h"
#include "rbpa/rbpa.h"

namespace figures {
namespace {

using rbpa::app::Shade;
using rbpa::app::Shades;

Points isolated_points(const Points& points, const rbpa::SolidAlphaComplex& complex) {
  Points isolated;
  for (const std::uint32_t i : complex.isolated) isolated.push_back(points[i]);
  return isolated;
}

double least_alpha(const rbpa::Filtration& filtration, std::optional<std::size_t> components = std::nullopt) {
  const auto alpha = rbpa::smallest_covering(filtration, components);
  if (!alpha) throw std::logic_error("no alpha covers the points of a figure");
  return *alpha;
}

/// Returns points that are dense on a ring, sparse around it, and absent inside. Coordinates are small multiples of
/// 1/16, so that the tests below are exact.
Points scattered(std::size_t count, std::uint64_t seed) {
  constexpr Place middle{2.5, 2.75};
  Random random(seed);
  Points points;
  const auto coordinate = [&](double size) { return std::floor(16 * size * random()) / 16; };
  while (points.size() < count) {
    const double x = coordinate(8);
    const Place p{x, coordinate(5.5)};
    const double out = length(p - middle), apart = out < 2.2 ? 0.4 : 0.7;
    const bool crowded = std::any_of(points.begin(), points.end(),
                                     [&](const rbpa::Point& q) { return length(place_of(q) - p) < apart; });
    if (out > 1.1 && !crowded) points.push_back({p.x, p.y});
  }
  return points;
}

/// Returns the dangling edges, those of the alpha complex that are in no triangle of it: between two points no farther
/// apart than 2α whose diametral disc has no third point.
std::vector<Segment> dangling_edges(const Points& points, const rbpa::SolidAlphaComplex& complex, double alpha) {
  std::vector<std::array<std::uint32_t, 2>> solid;
  for (const auto& [a, b, c] : rbpa::triangles(complex))
    for (const auto& [u, v] : {std::array{a, b}, {b, c}, {c, a}}) solid.push_back({std::min(u, v), std::max(u, v)});
  const auto between = [](const rbpa::Point& p, const rbpa::Point& q, const rbpa::Point& r) {
    return (p.x - r.x) * (q.x - r.x) + (p.y - r.y) * (q.y - r.y) <= 0;
  };
  std::vector<Segment> dangling;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (std::uint32_t j = i + 1; j < points.size(); ++j) {
      const rbpa::Point &p = points[i], &q = points[j];
      if ((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) > 4 * alpha * alpha) continue;
      const auto inside =
          std::count_if(points.begin(), points.end(), [&](const rbpa::Point& r) { return between(p, q, r); });
      if (inside > 2 || std::find(solid.begin(), solid.end(), std::array{i, j}) != solid.end()) continue;
      dangling.push_back({place_of(p), place_of(q), {}});
    }
  return dangling;
}

struct Pieces {
  std::size_t components = 0, holes = 0;
};

Pieces alive_at(double alpha, const std::vector<rbpa::PersistencePair>& pairs) {
  Pieces alive;
  for (const auto& pair : pairs)
    if (pair.birth <= alpha && (!pair.death || alpha < *pair.death))
      ++(pair.dimension == 0 ? alive.components : alive.holes);
  return alive;
}

std::string paper_1_complexes() {
  constexpr double alpha = 0.625;
  const Points points = scattered(68, 4);
  const auto complex = rbpa::rbpa(points, alpha);
  const auto counts = rbpa::count(complex);
  const auto solid = rbpa::outline_polygons(complex);
  const std::vector<Segment> dangling = dangling_edges(points, complex, alpha);
  const auto delaunay = rbpa::alpha_complex(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
  const Pieces full =
      alive_at(alpha, rbpa::persistence(delaunay, points, rbpa::filtration(delaunay, points), rbpa::ComplexKind::full));
  const std::size_t edges = counts.edges + dangling.size();
  if (points.size() + counts.triangles + full.holes != edges + full.components)
    throw std::logic_error("the dangling edges are not those of the alpha complex");

  const auto dangle = [dangling](Canvas& canvas, const Frame& frame) {
    std::vector<Segment> placed;
    for (const Segment& s : dangling) placed.push_back(frame.of(s));
    canvas.segments(placed, {color::touched, 2.4});
  };
  Panel alpha_complex =
      panel_over(points, "(a) alpha complex, alpha = " + rounded(alpha),
                 {of("points", points.size()) + " · " + of("edges", edges) + " · " + of("triangles", counts.triangles),
                  of("components", full.components) + " · " + of("holes", full.holes)});
  alpha_complex.more = [=](Canvas& canvas, const Frame& frame) {
    draw_complex(canvas, frame, complex, 2);
    dangle(canvas, frame);
    draw_points(canvas, frame, points, 2.6, color::text);
  };
  Panel solid_complex = panel_over(points, "(b) solid alpha complex",
                                   {of("points", counts.points_covered) + " · " + of("edges", counts.edges) + " · " +
                                        of("triangles", counts.triangles),
                                    of("components", counts.components) + " · " + of("holes", counts.holes)});
  solid_complex.more = [=](Canvas& canvas, const Frame& frame) {
    draw_complex(canvas, frame, complex, 2);
    std::vector<rbpa::Point> covered;
    for (const std::uint32_t i : complex.input_index) covered.push_back(points[i]);
    draw_points(canvas, frame, covered, 2.6, color::text);
  };
  Panel alpha_shape = panel_over(
      points, "(c) alpha shape",
      {of("dangling edges", dangling.size()) + " · " + of("points in no triangle", complex.isolated.size())});
  alpha_shape.more = [=](Canvas& canvas, const Frame& frame) {
    draw_solid(canvas, frame, points, solid, 2);
    dangle(canvas, frame);
    draw_points(canvas, frame, isolated_points(points, complex), 2.6, color::touched);
  };
  Panel alpha_solid = panel_over(points, "(d) alpha solid",
                                 {of("polygons", solid.size()) + " · " + of("holes", rbpa::total(solid).holes) +
                                  " · area " + rounded(rbpa::total(solid).area)});
  alpha_solid.more = [=](Canvas& canvas, const Frame& frame) { draw_solid(canvas, frame, points, solid, 2); };

  return Sheet("The alpha complex and the solid alpha complex of the same points, and their shapes", 42)
      .row({alpha_complex, solid_complex})
      .row({alpha_shape, alpha_solid})
      .svg();
}

/// Returns a point of the letter alpha, a curve that crosses itself, with two tails. `t` goes from −1.4 to 1.4.
Place alpha_curve(double t) { return {2.4 * t * t, 2.6 * t * (t * t - 1)}; }

/// Returns points on a stroke along the curve: one random point in each cell of a grid, kept if it is near the curve.
Points sampled_alpha() {
  constexpr double half_stroke = 0.42, cell = 0.15;
  std::vector<Place> curve;
  for (int i = -200; i <= 200; ++i) curve.push_back(alpha_curve(1.4 * i / 200));
  Random random(7);
  Points points;
  for (double y = -4; y < 4; y += cell)
    for (double x = -1; x < 6; x += cell) {
      const double right = x + cell * (0.25 + 0.5 * random()), up = y + cell * (0.25 + 0.5 * random());
      const bool near = std::any_of(curve.begin(), curve.end(), [&](Place p) {
        return length(p - Place{right, up}) <= half_stroke;
      });
      if (near) points.push_back({right, up});
    }
  return points;
}

std::string paper_7_alpha_symbol() {
  const Points points = sampled_alpha();
  const auto delaunay = rbpa::alpha_complex(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
  const auto filtration = rbpa::filtration(delaunay, points);
  const auto step = std::find_if(filtration.steps.begin(), filtration.steps.end(), [&](const rbpa::FiltrationStep& s) {
    return s.covered == points.size() && s.solid_components == 1 && s.holes == 1;
  });
  if (step == filtration.steps.end()) throw std::logic_error("no alpha gives the topology of the symbol");
  const double alpha = step->alpha;
  const auto complex = rbpa::rbpa(points, alpha);
  const auto counts = rbpa::count(complex);
  const auto solid = rbpa::outline_polygons(complex);
  const auto totals = rbpa::total(solid);

  Panel sampling = panel_over(points, "(a) sampling", {of("points", points.size())});
  sampling.more = [=](Canvas& canvas, const Frame& frame) { draw_points(canvas, frame, points, 1.3, color::text); };
  Panel triangles = panel_over(points, "(b) solid alpha complex",
                               {"alpha " + rounded(alpha) + " · " + of("triangles", counts.triangles),
                                of("components", counts.components) + " · " + of("holes", counts.holes)});
  triangles.more = [=](Canvas& canvas, const Frame& frame) { draw_complex(canvas, frame, complex, 1.4); };
  Panel polygon = panel_over(points, "(c) alpha solid",
                             {of("polygons", solid.size()) + " · " + of("holes", totals.holes),
                              "area " + rounded(totals.area) + " · perimeter " + rounded(totals.perimeter)});
  polygon.more = [=](Canvas& canvas, const Frame& frame) { draw_solid(canvas, frame, points, solid, 2); };
  return Sheet("The alpha symbol: sampling, solid alpha complex, alpha solid", 44)
      .row({sampling, triangles, polygon})
      .svg();
}

/// Returns an image of dark discs on a light ground: two rings of atoms with a common side, and an atom outside at
/// every free corner.
Shades molecule_image() {
  constexpr std::size_t width = 96, height = 72;
  Shades image{width, height, std::vector<Shade>(width * height, Shade::light)};
  const auto atom = [&](Place center, double radius) {
    for (std::size_t row = 0; row < height; ++row)
      for (std::size_t column = 0; column < width; ++column)
        if (length(Place{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5} - center) <= radius)
          image.pixels[row * width + column] = Shade::dark;
  };
  constexpr double bond = 17, large = 7.4, small = 4.2;
  const double apart = bond * std::sqrt(3.0) / 2;  // from the middle of a ring to the middles of its sides
  for (const double side : {-1.0, 1.0}) {
    const Place middle{width / 2.0 + side * apart, height / 2.0};
    for (int i = 0; i < 6; ++i) {
      const double degrees = 30 + 60 * i;
      atom(polar(degrees, bond, middle), large);
      const bool shared = std::abs(polar(degrees, bond, middle).x - width / 2.0) < bond / 2;
      if (!shared) atom(polar(degrees, bond + large + small + 1.6, middle), small);
    }
  }
  return image;
}

std::string paper_8_molecule() {
  const Shades image = molecule_image();
  const Points points = rbpa::app::foreground_points(image, std::nullopt);
  const auto delaunay = rbpa::alpha_complex(points, std::numeric_limits<double>::infinity(), {.neighbors = true});
  const rbpa::Filtration filtration = rbpa::filtration(delaunay, points);

  Panel pixels = panel_over(points, "(a) image",
                            {std::to_string(image.width) + " × " + std::to_string(image.height) + " pixels",
                             of("foreground", points.size())});
  pixels.more = [=](Canvas& canvas, const Frame& frame) {
    std::vector<std::vector<Place>> runs;  // runs of adjacent pixels, so that no seams are visible
    for (std::size_t first = 0, last = 0; first < points.size(); first = last + 1) {
      last = first;
      while (last + 1 < points.size() && points[last + 1] == rbpa::Point{points[last].x + 1, points[last].y}) ++last;
      const Place left = place_of(points[first]), right = place_of(points[last]);
      runs.push_back({frame(left + Place{-0.5, -0.5}), frame(right + Place{0.5, -0.5}), frame(right + Place{0.5, 0.5}),
                      frame(left + Place{-0.5, 0.5})});
    }
    canvas.region(runs, color::text);
  };
  std::vector<Panel> panels = {pixels};
  const auto closed = std::find_if(filtration.steps.rbegin(), filtration.steps.rend(),
                                   [](const rbpa::FiltrationStep& step) { return step.holes > 0; });
  const char* names[] = {"(b) ", "(c) ", "(d) "};
  std::size_t i = 0;
  for (const double alpha : {least_alpha(filtration), least_alpha(filtration, 1), closed.base()->alpha}) {
    const auto complex = rbpa::rbpa(points, alpha);
    const auto counts = rbpa::count(complex);
    const auto solid = rbpa::outline_polygons(complex);
    panels.push_back(panel_over(
        points, names[i++] + ("alpha = " + rounded(alpha) + " pixels"),
        {of("triangles", counts.triangles), of("components", counts.components) + " · " + of("holes", counts.holes)}));
    panels.back().more = [=](Canvas& canvas, const Frame& frame) {
      draw_solid(canvas, frame, points, solid, 1.4);
      draw_points(canvas, frame, isolated_points(points, complex), 1, color::touched);
    };
  }
  return Sheet("A molecule from the pixels of an image, at three radii", 3.2)
      .row({panels[0], panels[1]})
      .row({panels[2], panels[3]})
      .svg();
}

/// Returns the corners and middles of the unit squares marked #, as a set: at alpha 1/2, the marked squares are the
/// solid.
Points points_of(std::span<const std::string_view> rows) {
  Points points;
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      if (rows[row][column] != '#') continue;
      const double x = static_cast<double>(column), y = static_cast<double>(rows.size() - row) - 1;
      for (const double up : {0.0, 1.0})
        for (const double right : {0.0, 1.0}) points.push_back({x + right, y + up});
      points.push_back({x + 0.5, y + 0.5});
    }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Returns the points that lie on several rings, or on more than one polygon.
Points touching_points(const Points& points, std::span<const rbpa::Polygon> solid) {
  std::vector<std::size_t> rings(points.size(), 0);
  const auto count = [&](const rbpa::Ring& ring) {
    for (const std::uint32_t i : ring.points) ++rings[i];
  };
  for (const rbpa::Polygon& polygon : solid) {
    count(polygon.shell);
    for (const rbpa::Ring& hole : polygon.holes) count(hole);
  }
  Points touching;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (rings[i] > 1) touching.push_back(points[i]);
  return touching;
}

std::string shape_rings() {
  constexpr std::array<std::string_view, 8> picture = {"#######.######",  //
                                                       "#.....#.#.####",  //
                                                       "#.###.#.##.###",  //
                                                       "#.#.#.#.#####.",  //
                                                       "#.###.#.####.#",  //
                                                       "#.....#.######",  //
                                                       "#######.######",  //
                                                       ".......#......"};
  const Points points = points_of(picture);
  const auto complex = rbpa::rbpa(points, 0.5);
  const auto counts = rbpa::count(complex);

  Panel triangles =
      panel_over(points, "(a) solid alpha complex",
                 {of("solid components", counts.solid_components) + " · " + of("components", counts.components),
                  of("boundary curves", counts.boundary_curves)});
  triangles.more = [=](Canvas& canvas, const Frame& frame) { draw_complex(canvas, frame, complex, 2); };
  std::vector<Panel> panels = {triangles};
  const auto add = [&](std::string heading, const rbpa::PolygonFilter& filter) {
    const auto solid = rbpa::outline_polygons(complex, filter);
    const auto totals = rbpa::total(solid);
    const Points touching = touching_points(points, solid);
    panels.push_back(panel_over(
        points, std::move(heading),
        {of("polygons", solid.size()) + " · " + of("holes", totals.holes) + " · area " + rounded(totals.area),
         of("points where rings touch", touching.size())}));
    panels.back().more = [=](Canvas& canvas, const Frame& frame) {
      draw_solid(canvas, frame, points, solid, 2);
      std::vector<std::vector<Place>> holes;
      for (const rbpa::Polygon& polygon : solid)
        for (const rbpa::Ring& hole : polygon.holes) {
          holes.emplace_back();
          for (const std::uint32_t i : hole.points) holes.back().push_back(frame(place_of(points[i])));
        }
      canvas.closed_lines(holes, {color::touched, 2});
      draw_points(canvas, frame, touching, 3.6, color::text);
    };
  };
  add("(b) polygons: shells blue, holes orange", {});
  add("(c) min_hole_area 2, min_part_area 2", {.min_hole_area = 2, .min_part_area = 2});
  add("(d) min_hole_area 26, min_part_area 2", {.min_hole_area = 26, .min_part_area = 2});
  return Sheet("Boundary curves become rings, rings become polygons; holes and parts are filtered", 24)
      .row({panels[0], panels[1]})
      .row({panels[2], panels[3]})
      .svg();
}

}  // namespace

std::span<const Figure> shape_figures() {
  static constexpr std::array figures = {
      Figure{"paper_1_complexes", paper_1_complexes}, Figure{"paper_7_alpha_symbol", paper_7_alpha_symbol},
      Figure{"paper_8_molecule", paper_8_molecule}, Figure{"shape_rings", shape_rings}};
  return figures;
}

}  // namespace figures
