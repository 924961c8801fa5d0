#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawings/caption.h"
#include "drawings/drawn_complex.h"
#include "drawings/figures.h"
#include "drawings/random.h"
#include "drawings/sheet.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/patches/find_patch.h"
#include "rbpa/plane/remainder/remainder.h"
#include "rbpa/plane/tile/cut.h"

namespace figures {
namespace {

using Corners3 = std::array<std::uint32_t, 3>;

/// Returns uniform points in a square of side 12 except for an empty disc, and many points near one place.
Points with_a_dense_place_and_a_gap() {
  Points points;
  Random random(11);
  const Place gap{8.6, 8.4}, dense{4.1, 6.2};
  for (int row = 0; row < 24; ++row)
    for (int column = 0; column < 24; ++column) {
      const double x = 0.5 * (column + 0.1 + 0.8 * random()), y = 0.5 * (row + 0.1 + 0.8 * random());
      if (length(Place{x, y} - gap) > 1.7) points.push_back({x, y});
    }
  for (int i = 0; i < 700; ++i) {
    const double right = dense.x + 0.22 * random();
    points.push_back({right, dense.y + 0.22 * random()});
  }
  return points;
}

/// Result of one tile.
struct OfTile {
  rbpa::Tile tile;
  std::vector<Corners3> triangles;
  std::set<std::uint32_t> settled;
};

/// All tiles of a set of points, and the remainder; numbers are sites.
struct Tiling {
  std::vector<Place> places;
  std::vector<OfTile> tiles;
  std::vector<std::uint32_t> not_done;
  std::vector<Corners3> missing;
};

std::vector<Corners3> triangles_of(const meshops::Patch& patch) {
  std::vector<Corners3> triangles;
  for (const auto& corners : patch.triangles) {
    triangles.push_back({});
    std::transform(corners.begin(), corners.end(), triangles.back().begin(),
                   [](auto site) { return static_cast<std::uint32_t>(site); });
  }
  return triangles;
}

/// Throws unless the triangles of all patches are the complex, so that no wrong figure is drawn.
void require_complex(const Tiling& tiling, const rbpa::Sites& sites, const Points& points, double alpha) {
  std::vector<Corners3> found;
  const auto add = [&](const std::vector<Corners3>& triangles) {
    for (Corners3 t : triangles) {
      for (std::uint32_t& corner : t) corner = sites.input_index()[corner];
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      found.push_back(t);
    }
  };
  for (const OfTile& tile : tiling.tiles) add(tile.triangles);
  add(tiling.missing);
  std::sort(found.begin(), found.end());
  if (found != rbpa::alpha_complex(points, alpha).triangles)
    throw std::logic_error("the patches that are drawn are not the complex");
}

Tiling tiling_of(const Points& points, double alpha, std::uint32_t max_points) {
  rbpa::Threads threads(1);
  const rbpa::Sites sites(points, threads);
  const rbpa::Radius radius = rbpa::Radius::of(alpha);
  if (sites.window().exponent != 0 || !sites.beyond().empty())
    throw std::logic_error("the points do not lie in the window as they are");
  Tiling tiling;
  for (const rbpa::Point& p : sites.points()) tiling.places.push_back(place_of(p));
  rbpa::Cutter cutter(sites.grid(), sites.hidden());
  rbpa::FinderWorkspace workspace;
  rbpa::TilePatch found;
  rbpa::Remainder remainder(sites, radius);
  for (const rbpa::Block& block : rbpa::blocks(sites.grid(), max_points)) {
    OfTile of;
    cutter.cut(block, of.tile);
    rbpa::find_patch(of.tile, sites.window().scaled(radius), workspace, found);
    of.triangles = triangles_of(found.patch);
    of.settled.insert(found.settled.begin(), found.settled.end());
    remainder.add(found);
    tiling.tiles.push_back(std::move(of));
  }
  tiling.not_done = remainder.not_done();
  rbpa::TilePatch rest;
  remainder.complete(
      threads, [] {}, rest);
  tiling.missing = triangles_of(rest.patch);
  require_complex(tiling, sites, points, alpha);
  return tiling;
}

/// Returns the tile with the most unknown cells.
const OfTile& most_telling(const std::vector<OfTile>& tiles) {
  const auto unknown = [](const OfTile& of) { return of.tile.unknown.empty() ? 0 : of.tile.unknown.back(); };
  return *std::max_element(tiles.begin(), tiles.end(),
                           [&](const OfTile& l, const OfTile& r) { return unknown(l) < unknown(r); });
}

std::vector<Place> box(const Frame& frame, Place low, Place high) {
  return {frame(low), frame({high.x, low.y}), frame(high), frame({low.x, high.y})};
}

void draw_cells(Canvas& canvas, const Frame& frame, const rbpa::Tile& tile) {
  std::vector<std::vector<Place>> unknown;
  for (std::size_t c = 0; c + 1 < tile.unknown.size(); ++c) {
    if (tile.unknown[c] == tile.unknown[c + 1]) continue;
    const auto columns = static_cast<std::size_t>(tile.columns);
    const Place low{tile.x0 + static_cast<double>(c % columns) * tile.cell,
                    tile.y0 + static_cast<double>(c / columns) * tile.cell};
    unknown.push_back(box(frame, low, low + Place{tile.cell, tile.cell}));
  }
  canvas.region(unknown, color::touched_face);
  std::vector<Segment> lines;
  for (int i = 0; i <= tile.columns; ++i) {
    const double x = tile.x0 + i * tile.cell;
    lines.push_back({frame({x, tile.y0}), frame({x, tile.y1()}), {}});
  }
  for (int i = 0; i <= tile.rows; ++i) {
    const double y = tile.y0 + i * tile.cell;
    lines.push_back({frame({tile.x0, y}), frame({tile.x1(), y}), {}});
  }
  canvas.segments(lines, {color::pale, 0.7});
}

void draw_triangles(Canvas& canvas, const Frame& frame, const std::vector<Place>& places,
                    const std::vector<Corners3>& triangles, std::string_view fill) {
  std::vector<std::vector<Place>> faces;
  for (const Corners3& t : triangles) faces.push_back({frame(places[t[0]]), frame(places[t[1]]), frame(places[t[2]])});
  canvas.region(faces, fill);
  canvas.closed_lines(faces, {color::inner, 0.7});
}

std::vector<Place> owned(const rbpa::Tile& tile, bool wanted) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < tile.points.size(); ++i)
    if ((tile.owned[i] != 0) == wanted) places.push_back(place_of(tile.points[i]));
  return places;
}

std::vector<Place> seen(const Frame& frame, std::vector<Place> places) {
  for (Place& p : places) p = frame(p);
  return places;
}

std::string tile() {
  constexpr double alpha = 1.9;
  const Points points = with_a_dense_place_and_a_gap();
  const Tiling tiling = tiling_of(points, alpha, 100);
  const OfTile& one = most_telling(tiling.tiles);

  Panel cut = panel_over(
      points, "(a) one tile",
      {of("owned", owned(one.tile, true).size()) + " · " + of("ghosts", owned(one.tile, false).size()),
       "of " + std::to_string(points.size()) + " points, " + std::to_string(tiling.tiles.size()) + " tiles"});
  cut.more = [=](Canvas& canvas, const Frame& frame) {
    draw_cells(canvas, frame, one.tile);
    canvas.dots(seen(frame, tiling.places), 1.4, color::pale);
    canvas.dots(seen(frame, owned(one.tile, false)), 1.8, color::inner);
    canvas.dots(seen(frame, owned(one.tile, true)), 2.2, color::text);
  };

  std::vector<Place> settled, unsettled;
  for (std::size_t i = 0; i < one.tile.points.size(); ++i)
    if (one.tile.owned[i] != 0)
      (one.settled.contains(one.tile.site[i]) ? settled : unsettled).push_back(place_of(one.tile.points[i]));
  Panel patch = panel_over(points, "(b) its patch",
                           {of("triangles", one.triangles.size()),
                            of("settled stars", settled.size()) + " · others " + std::to_string(unsettled.size())});
  patch.more = [=](Canvas& canvas, const Frame& frame) {
    draw_cells(canvas, frame, one.tile);
    canvas.dots(seen(frame, tiling.places), 1.4, color::pale);
    draw_triangles(canvas, frame, tiling.places, one.triangles, color::face);
    canvas.dots(seen(frame, settled), 2.2, color::text);
    canvas.dots(seen(frame, unsettled), 2.6, color::touched);
  };

  std::size_t found = 0;
  for (const OfTile& tile : tiling.tiles) found += tile.triangles.size();
  Panel rest = panel_over(points, "(c) what is left over",
                          {of("triangles of all patches", found) + " · left " + std::to_string(tiling.missing.size()),
                           "points for these " + std::to_string(tiling.not_done.size())});
  rest.more = [=](Canvas& canvas, const Frame& frame) {
    for (const OfTile& tile : tiling.tiles) draw_triangles(canvas, frame, tiling.places, tile.triangles, color::face);
    draw_triangles(canvas, frame, tiling.places, tiling.missing, color::touched_face);
    std::vector<Place> places;
    for (const std::uint32_t site : tiling.not_done) places.push_back(tiling.places[site]);
    canvas.dots(seen(frame, places), 1.8, color::touched);
  };
  for (Panel* panel : {&cut, &patch, &rest})
    for (const Place corner : {Place{one.tile.x0, one.tile.y0}, {one.tile.x1(), one.tile.y1()}})
      panel->extent.push_back(corner);
  return Sheet("A tile: its points and ghosts, the patch found on it, and what all tiles leave over", 26, 310)
      .row({cut, patch, rest})
      .svg();
}

}  // namespace

std::span<const Figure> tile_figures() {
  static constexpr std::array figures = {Figure{"tile", tile}};
  return figures;
}

}  // namespace figures
