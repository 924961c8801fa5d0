#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "drawings/caption.h"
#include "drawings/drawn_complex.h"
#include "drawings/figures.h"
#include "drawings/random.h"
#include "drawings/sheet.h"
#include "meshops/core/live.h"
#include "rbpa/hrbpa.h"
#include "rbpa/paper.h"
#include "rbpa/paper/point_quadtree.h"

namespace figures {
namespace {

using rbpa::Hierarchy;

/// Leaf of a quadtree.
struct Leaf {
  Place low;
  double side;
  std::size_t points;

  Place middle() const { return low + 0.5 * Place{side, side}; }
  std::vector<Place> corners() const {
    return {low, low + Place{side, 0}, low + Place{side, side}, low + Place{0, side}};
  }
};

std::vector<Leaf> quadtree(const Points& points, std::size_t capacity) {
  std::vector<Leaf> leaves;
  for (const rbpa::paper::Leaf& leaf : rbpa::paper::quadtree(points, capacity))
    leaves.push_back(
        {{static_cast<double>(leaf.x), static_cast<double>(leaf.y)}, static_cast<double>(leaf.side), leaf.points});
  return leaves;
}

double smallest_side(const std::vector<Leaf>& leaves) {
  return std::min_element(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) { return a.side < b.side; })
      ->side;
}

/// Computes the hierarchy by the paper's own method.
Hierarchy hierarchy_of(const Points& points, double alpha, std::size_t leaf_capacity) {
  return rbpa::paper::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .progress = {}});
}

/// Throws unless the default search, which counts points in squares in another way, finds the same least radius.
void require_least_radius(const Points& points, std::size_t leaf_capacity, const std::vector<Leaf>& leaves) {
  const double side = smallest_side(leaves);
  if (rbpa::hrbpa(points, side, {.leaf_capacity = leaf_capacity, .progress = {}}).least_radius != side / 2)
    throw std::logic_error("the leaves that are drawn are not those of the library");
}

/// Draws the leaves and fills those of the given side.
void draw_leaves(Canvas& canvas, const Frame& frame, const std::vector<Leaf>& leaves, double marked) {
  std::vector<std::vector<Place>> all, filled;
  for (const Leaf& leaf : leaves) {
    std::vector<Place> corners;
    for (const Place corner : leaf.corners()) corners.push_back(frame(corner));
    if (leaf.side == marked) filled.push_back(corners);
    all.push_back(std::move(corners));
  }
  canvas.region(filled, color::touched_face);
  canvas.closed_lines(all, {color::inner, 0.8});
  canvas.closed_lines(filled, {color::touched, 1.2});
}

/// State after a level, and the points that are carried to the next one.
struct AfterLevel {
  std::vector<std::vector<Place>> earlier, fresh;  ///< triangles
  std::vector<Segment> inner, boundary;
  Points carried, left_behind;
  bool is_last;

  AfterLevel(const Hierarchy& hierarchy, const Points& points, std::size_t level)
      : is_last(level + 1 == hierarchy.levels.size()) {
    const auto& [mesh, input_index, isolated, duplicates, distinct] = hierarchy.complex;
    const auto place = [&, &mesh = mesh](Vertex v) { return Place{mesh.point(v)[0], mesh.point(v)[1]}; };
    const auto is_there = [&](Face f) {
      return f.is_valid() && rbpa::level_of(hierarchy, static_cast<std::size_t>(f.idx())) <= level;
    };
    std::vector<bool> covered(points.size()), open(points.size());
    meshops::for_each_face(mesh, [&, &mesh = mesh, &input_index = input_index](Face f) {
      if (!is_there(f)) return;
      const bool is_fresh = rbpa::level_of(hierarchy, static_cast<std::size_t>(f.idx())) == level;
      auto& corners = (is_fresh ? fresh : earlier).emplace_back();
      for (const Vertex v : mesh.fv_range(f)) {
        corners.push_back(place(v));
        covered[input_index[static_cast<std::size_t>(v.idx())]] = true;
      }
    });
    meshops::for_each_edge(mesh, [&, &mesh = mesh, &input_index = input_index](Edge e) {
      const Halfedge h = mesh.halfedge_handle(e, 0);
      const int sides = int{is_there(mesh.face_handle(h))} + int{is_there(mesh.opposite_face_handle(h))};
      const std::array ends = {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)};
      if (sides > 0) (sides == 1 ? boundary : inner).push_back({place(ends[0]), place(ends[1]), {}});
      if (sides == 1)
        for (const Vertex v : ends) open[input_index[static_cast<std::size_t>(v.idx())]] = true;
    });
    for (std::size_t i = 0; i < points.size(); ++i)
      (!covered[i] || open[i] ? carried : left_behind).push_back(points[i]);
    if (is_last) return;
    const rbpa::Level& next = hierarchy.levels[level + 1];
    if (carried.size() != next.transferred || boundary.size() != next.advancing)
      throw std::logic_error("what is drawn as carried on is not what the run carried on");
  }
};

std::vector<std::vector<Place>> in_frame(const Frame& frame, std::vector<std::vector<Place>> rings) {
  for (auto& ring : rings)
    for (Place& p : ring) p = frame(p);
  return rings;
}

std::vector<Segment> in_frame(const Frame& frame, std::vector<Segment> segments) {
  for (Segment& s : segments) s = frame.of(s);
  return segments;
}

/// Draws a level: earlier triangles are gray; the boundary and the carried points are marked, if any point is carried.
void draw_level(Canvas& canvas, const Frame& frame, const AfterLevel& after, double dot) {
  canvas.region(in_frame(frame, after.earlier), color::pale);
  canvas.region(in_frame(frame, after.fresh), color::face);
  canvas.segments(in_frame(frame, after.inner), {color::inner, 0.7});
  canvas.segments(in_frame(frame, after.boundary), {after.is_last ? color::curve : color::touched, 2});
  draw_points(canvas, frame, after.left_behind, dot * 0.6, color::inner);
  if (!after.is_last) draw_points(canvas, frame, after.carried, dot, color::touched);
}

/// Returns points that get denser toward a place: random candidates, kept if no other is nearer than their distance
/// allows.
Points thinning_out(Place middle, Place size, std::size_t tries, double nearest, double growth, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i < tries; ++i) {
    const double x = size.x * random();
    const Place p{x, size.y * random()};
    const double apart = nearest + growth * length(p - middle);
    const bool crowded = std::any_of(points.begin(), points.end(),
                                     [&](const rbpa::Point& q) { return length(place_of(q) - p) < apart; });
    if (!crowded) points.push_back({p.x, p.y});
  }
  return points;
}

/// Window that shows a part of the plane, enlarged.
struct Window {
  Place low;
  double side;
  double times;

  bool holds(Place p) const { return p.x >= low.x && p.y >= low.y && p.x <= low.x + side && p.y <= low.y + side; }
  Place clamped(Place p) const { return {std::clamp(p.x, low.x, low.x + side), std::clamp(p.y, low.y, low.y + side)}; }
  std::vector<Place> corners() const { return Leaf{low, side, 0}.corners(); }
};

/// Draws the smallest leaf with its inscribed circle, whose radius it gives.
void draw_enlarged(Canvas& canvas, const Frame& frame, const Window& window, const std::vector<Leaf>& leaves,
                   const Points& points, const Leaf& smallest) {
  std::vector<std::vector<Place>> rings, marked;
  for (const Leaf& leaf : leaves) {
    std::vector<Place> corners = leaf.corners();
    for (Place& corner : corners) corner = frame(window.clamped(corner));
    if (corners[0].x >= corners[2].x || corners[0].y <= corners[2].y) continue;
    (leaf.side == smallest.side ? marked : rings).push_back(corners);
  }
  canvas.region(marked, color::touched_face);
  canvas.closed_lines(rings, {color::inner, 0.8});
  canvas.closed_lines(marked, {color::touched, 1.4});
  const Place middle = smallest.middle();
  canvas.circle(frame(middle), frame.scale * smallest.side / 2, {color::text, 1.6});
  const Segment radius{middle, middle + Place{smallest.side / 2, 0}, {}};
  canvas.segment(frame.of(radius), {color::text, 1.6});
  canvas.text(frame(radius.middle()) + Place{0, 16}, "α₀", Lettering::italic, Align::middle);
  Points near;
  for (const rbpa::Point& p : points)
    if (window.holds(place_of(p))) near.push_back(p);
  draw_points(canvas, frame, near, 3.2, color::text);
}

std::string paper_4_least_radius() {
  constexpr std::size_t capacity = 4;
  const Points points = thinning_out({2.1, 1.65}, {6, 6}, 6000, 0.05, 0.25, 6);
  const std::vector<Leaf> leaves = quadtree(points, capacity);
  require_least_radius(points, capacity, leaves);
  const double side = smallest_side(leaves);
  const Leaf smallest = *std::max_element(leaves.begin(), leaves.end(), [&](const Leaf& a, const Leaf& b) {
    return std::pair(-a.side, a.points) < std::pair(-b.side, b.points);
  });
  const auto equal = std::count_if(leaves.begin(), leaves.end(), [&](const Leaf& leaf) { return leaf.side == side; });
  constexpr double size = 6, times = 8, around = size / times;
  Place low{size, size}, high;
  for (const Leaf& leaf : leaves) {
    if (leaf.side != side) continue;
    low = {std::min(low.x, leaf.low.x), std::min(low.y, leaf.low.y)};
    high = {std::max(high.x, leaf.low.x + side), std::max(high.y, leaf.low.y + side)};
  }
  const Window window{0.5 * (low + high) - Place{around / 2, around / 2}, around, times};

  Panel tree = panel_over(points, "(a) at most " + std::to_string(capacity) + " points in a leaf",
                          {of("points", points.size()) + " · " + of("leaves", leaves.size()),
                           std::to_string(equal) + " leaves of the smallest size"});
  tree.extent = {{0, 0}, {size, size}};
  tree.more = [=](Canvas& canvas, const Frame& frame) {
    draw_leaves(canvas, frame, leaves, side);
    draw_points(canvas, frame, points, 2.2, color::text);
    std::vector<Place> border = window.corners();
    for (Place& corner : border) corner = frame(corner);
    canvas.closed_lines({border}, {color::text, 1.2, true});
  };
  Panel radius = panel_over(points, "(b) the smallest leaves, " + rounded(times) + " times as large",
                            {"side " + rounded(side) + " · α₀ " + rounded(side / 2)});
  radius.extent = tree.extent;
  radius.more = [=](Canvas& canvas, const Frame& frame) {
    const Place corner = frame({0, 0});
    const double scale = frame.scale * window.times;
    const Frame enlarged{{corner.x - scale * window.low.x, corner.y + scale * window.low.y}, scale};
    draw_enlarged(canvas, enlarged, window, leaves, points, smallest);
    std::vector<Place> border = window.corners();
    for (Place& p : border) p = enlarged(p);
    canvas.closed_lines({border}, {color::text, 1.2, true});
  };
  return Sheet("The least radius: half the side of the smallest leaf of a quadtree", 56).row({tree, radius}).svg();
}

std::string paper_5_level_transfer() {
  const Points points = thinning_out({3.2, 3.6}, {9.6, 7.6}, 8000, 0.16, 0.17, 8);
  const Hierarchy hierarchy = hierarchy_of(points, std::numeric_limits<double>::infinity(), 8);
  Sheet sheet("Three levels of hierarchical ball pivoting: what is carried on and what is left behind", 31);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < 3; ++i) {
    const AfterLevel after(hierarchy, points, i);
    const rbpa::Level& level = hierarchy.levels[i];
    panels.push_back(
        panel_over(points, "level " + std::to_string(level.number) + ", alpha = " + rounded(level.alpha),
                   {of("new triangles", after.fresh.size()) + " of " + std::to_string(level.triangles),
                    of("carried on", after.carried.size()) + " · " + of("left behind", after.left_behind.size())}));
    panels.back().more = [=](Canvas& canvas, const Frame& frame) { draw_level(canvas, frame, after, 2.6); };
  }
  return sheet.row(panels).svg();
}

/// Returns 700 points in a square of 16 × 16 blocks of side 2. In 148 blocks along a wave there are four points, each
/// in a quarter of its own; in each of the others there is one.
Points two_densities() {
  constexpr int blocks = 16;
  constexpr std::size_t dense_blocks = 148;
  struct Block {
    double from_wave;
    int column, row;
  };
  std::vector<Block> order;
  for (int row = 0; row < blocks; ++row)
    for (int column = 0; column < blocks; ++column) {
      const Place middle{2.0 * column + 1, 2.0 * row + 1};
      double from_wave = 100;
      for (int i = 0; i <= 320; ++i) {
        const double x = 0.1 * i, bump = (x - 16) / 16;
        from_wave = std::min(from_wave, length(middle - Place{x, 25 - 18 * (1 - bump * bump) * (1 - bump * bump)}));
      }
      order.push_back({from_wave, column, row});
    }
  std::stable_sort(order.begin(), order.end(),
                   [](const Block& a, const Block& b) { return a.from_wave < b.from_wave; });
  Random random(9);
  Points points;
  const auto add = [&](double x, double y, double side) {
    const double right = x + side * (0.35 + 0.3 * random());
    points.push_back({right, y + side * (0.35 + 0.3 * random())});
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double x = 2.0 * order[i].column, y = 2.0 * order[i].row;
    if (i >= dense_blocks)
      add(x, y, 2);
    else
      for (const Place quarter : {Place{0, 0}, {1, 0}, {0, 1}, {1, 1}}) add(x + quarter.x, y + quarter.y, 1);
  }
  return points;
}

std::string paper_9_two_levels() {
  constexpr std::size_t capacity = 9;
  const Points points = two_densities();
  const std::vector<Leaf> leaves = quadtree(points, capacity);
  const double side = smallest_side(leaves);
  const Hierarchy hierarchy = hierarchy_of(points, side, capacity);
  require_least_radius(points, capacity, leaves);
  const auto& levels = hierarchy.levels;
  if (levels.size() != 2 || rbpa::triangles(hierarchy.complex) != rbpa::triangles(rbpa::rbpa(points, side)))
    throw std::logic_error("the sampling does not have two levels");

  const std::size_t small = static_cast<std::size_t>(
      std::count_if(leaves.begin(), leaves.end(), [&](const Leaf& l) { return l.side == side; }));
  Panel sampling = panel_over(points, "(a) sampling and quadtree",
                              {of("points", points.size()) + " · " + of("leaves", leaves.size()),
                               std::to_string(small) + " leaves of side 2α₀ = " + rounded(side)});
  sampling.more = [=](Canvas& canvas, const Frame& frame) {
    draw_leaves(canvas, frame, leaves, side);
    draw_points(canvas, frame, points, 1.5, color::text);
  };
  std::vector<Panel> panels = {sampling};
  const char* names[] = {"(b) α = α₀ = ", "(c) α = 2α₀ = "};
  for (std::size_t i = 0; i < 2; ++i) {
    const AfterLevel after(hierarchy, points, i);
    panels.push_back(
        panel_over(points, names[i] + rounded(levels[i].alpha),
                   {of("points taking part", levels[i].taking_part) + " of " + std::to_string(points.size()),
                    of("new triangles", after.fresh.size()) + " of " + std::to_string(levels[i].triangles) +
                        (after.is_last ? "" : " · " + of("carried on", after.carried.size()))}));
    panels.back().more = [=](Canvas& canvas, const Frame& frame) { draw_level(canvas, frame, after, 1.5); };
  }
  return Sheet("Two levels: a sampling of two densities, after the first level, and at the double radius", 10)
      .row(panels)
      .svg();
}

/// Colors from the first level to the last.
constexpr std::array level_colors = {"#0b3d6b", "#1f6fb2", "#5b9bcf", "#9cc4e4", "#cfe2f2", "#f1f4f7"};

/// Draws a bar for each level, whose length is its number of triangles, up to a width; and the number in words.
void draw_levels(Canvas& canvas, const Frame& frame, const std::vector<rbpa::Level>& levels, Place top, double width) {
  std::vector<std::size_t> fresh;
  for (std::size_t i = 0; i < levels.size(); ++i)
    fresh.push_back(levels[i].triangles - (i == 0 ? 0 : levels[i - 1].triangles));
  const auto most = static_cast<double>(*std::max_element(fresh.begin(), fresh.end()));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Place at = top - Place{0, static_cast<double>(i)};
    const double length = width * static_cast<double>(fresh[i]) / most;
    const std::vector<Place> bar = {frame(at), frame(at + Place{length, 0}), frame(at + Place{length, -0.42}),
                                    frame(at + Place{0, -0.42})};
    canvas.region({bar}, level_colors[i]);
    canvas.closed_lines({bar}, {color::inner, 0.7});
    canvas.text(frame(at) - Place{0, 5}, "alpha = " + rounded(levels[i].alpha) + ": " + std::to_string(fresh[i]),
                Lettering::small);
  }
}

std::string levels() {
  const Points points = thinning_out({3.2, 3.6}, {9.6, 7.6}, 20000, 0.05, 0.16, 8);
  const Hierarchy hierarchy = rbpa::hrbpa(points, 3, {.leaf_capacity = 6, .progress = {}});
  const auto& levels = hierarchy.levels;
  if (levels.size() > level_colors.size() || hierarchy.complex.mesh.n_faces() != levels.back().triangles)
    throw std::logic_error("there are more levels than colors: " + std::to_string(levels.size()));
  std::vector<std::vector<std::vector<Place>>> by_level(levels.size());
  const rbpa::Mesh& mesh = hierarchy.complex.mesh;
  meshops::for_each_face(mesh, [&](Face f) {
    auto& corners = by_level[rbpa::level_of(hierarchy, static_cast<std::size_t>(f.idx()))].emplace_back();
    for (const Vertex v : mesh.fv_range(f)) corners.push_back({mesh.point(v)[0], mesh.point(v)[1]});
  });
  Panel triangles = panel_over(points, "(a) every triangle by its level",
                               {of("points", points.size()) + " · " + of("triangles", mesh.n_faces()),
                                "least radius " + rounded(hierarchy.least_radius)});
  triangles.more = [=](Canvas& canvas, const Frame& frame) {
    for (std::size_t i = by_level.size(); i-- > 0;) {
      canvas.region(in_frame(frame, by_level[i]), level_colors[i]);
      canvas.closed_lines(in_frame(frame, by_level[i]), {color::text, 0.4});
    }
  };
  Panel counts =
      panel_over({}, "(b) triangles a level", {"a level has the triangles of", "circumradius up to its alpha"});
  counts.extent = {{0, 7.4 - static_cast<double>(levels.size())}, {8.3, 7.4}};
  counts.more = [=](Canvas& canvas, const Frame& frame) { draw_levels(canvas, frame, levels, {0.3, 6.8}, 8); };
  return Sheet("The levels of a hierarchy: each triangle comes with the first radius that admits it", 34)
      .row({triangles, counts})
      .svg();
}

}  // namespace

std::span<const Figure> hierarchy_figures() {
  static constexpr std::array figures = {Figure{"paper_4_least_radius", paper_4_least_radius}, Figure{"levels", levels},
                                         Figure{"paper_5_level_transfer", paper_5_level_transfer},
                                         Figure{"paper_9_two_levels", paper_9_two_levels}};
  return figures;
}

}  // namespace figures
