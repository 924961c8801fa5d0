// What: one tile of a complex: what it owns, its patch, and what all tiles leave over.
#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "drawings/figures.h"
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

Place place_of(const rbpa::Point& p) { return {p.x, p.y}; }

/// Returns uniform points in a square of side 12 except for an empty disc, and many points near one place.
std::vector<rbpa::Point> with_a_dense_place_and_a_gap() {
  std::vector<rbpa::Point> points;
  std::mt19937_64 engine(11);
  const auto random = [&] { return static_cast<double>(engine() >> 11U) * 0x1p-53; };  // equal on every platform
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

/// All tiles of a set of points with their patches, and the remainder; numbers are sites.
struct Tiling {
  struct OfTile {
    rbpa::Tile tile;
    std::vector<Corners3> triangles;
    std::set<std::uint32_t> settled;
  };
  std::vector<Place> places;
  std::vector<OfTile> tiles;
  std::vector<std::uint32_t> not_done;
  std::vector<Corners3> missing;
};

std::vector<Corners3> triangles_of(const meshops::Patch& patch) {
  std::vector<Corners3> triangles;
  for (const auto& [a, b, c] : patch.triangles)
    triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  return triangles;
}

Tiling tiling_of(const std::vector<rbpa::Point>& points, double alpha, std::uint32_t max_points) {
  rbpa::Threads threads(1);
  const rbpa::Sites sites(points, threads);
  const rbpa::Radius radius = rbpa::Radius::of(alpha);
  Tiling tiling;
  for (const rbpa::Point& p : sites.points()) tiling.places.push_back(place_of(p));
  rbpa::Cutter cutter(sites.grid(), sites.hidden());
  rbpa::FinderWorkspace workspace;
  rbpa::TilePatch found, rest;
  rbpa::Remainder remainder(sites, radius);
  std::vector<Corners3> all;
  const auto add = [&](const std::vector<Corners3>& triangles) {
    for (Corners3 t : triangles) {
      for (std::uint32_t& corner : t) corner = sites.input_index()[corner];
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      all.push_back(t);
    }
  };
  for (const rbpa::Block& block : rbpa::blocks(sites.grid(), max_points)) {
    Tiling::OfTile of;
    cutter.cut(block, of.tile);
    rbpa::find_patch(of.tile, sites.window().scaled(radius), workspace, found);
    of.triangles = triangles_of(found.patch);
    of.settled.insert(found.settled.begin(), found.settled.end());
    remainder.add(found);
    add(of.triangles);
    tiling.tiles.push_back(std::move(of));
  }
  tiling.not_done = remainder.not_done();
  remainder.complete(
      threads, [] {}, rest);
  tiling.missing = triangles_of(rest.patch);
  add(tiling.missing);
  std::sort(all.begin(), all.end());
  if (all != rbpa::alpha_complex(points, alpha).triangles)
    throw std::logic_error("the patches that are drawn are not the complex");
  return tiling;
}

/// Canvas of a panel, on which everything is placed by its frame.
struct Drawing {
  Canvas& canvas;
  const Frame& frame;

  std::vector<Place> seen(std::vector<Place> places) const {
    for (Place& p : places) p = frame(p);
    return places;
  }
  void dots(const std::vector<Place>& places, double radius, std::string_view ink) const {
    canvas.dots(seen(places), radius, ink);
  }
  void cells(const rbpa::Tile& tile) const {
    std::vector<std::vector<Place>> unknown;
    std::vector<Segment> lines;
    for (std::size_t c = 0; c + 1 < tile.unknown.size(); ++c) {
      if (tile.unknown[c] == tile.unknown[c + 1]) continue;
      const auto columns = static_cast<std::size_t>(tile.columns);
      const Place low{tile.x0 + static_cast<double>(c % columns) * tile.cell,
                      tile.y0 + static_cast<double>(c / columns) * tile.cell};
      const Place high = low + Place{tile.cell, tile.cell};
      unknown.push_back(seen({low, {high.x, low.y}, high, {low.x, high.y}}));
    }
    canvas.region(unknown, color::touched_face);
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
  void triangles(const Tiling& tiling, const std::vector<Corners3>& corners, std::string_view fill) const {
    std::vector<std::vector<Place>> faces;
    for (const auto& [a, b, c] : corners) faces.push_back(seen({tiling.places[a], tiling.places[b], tiling.places[c]}));
    canvas.region(faces, fill);
    canvas.closed_lines(faces, {color::inner, 0.7});
  }
};

std::string number(const char* name, std::size_t value) { return name + std::to_string(value); }

}  // namespace

std::string tile() {
  const std::vector<rbpa::Point> points = with_a_dense_place_and_a_gap();
  const Tiling tiling = tiling_of(points, 1.9, 100);
  // The tile with the most unknown cells.
  const auto unknown = [](const Tiling::OfTile& of) { return of.tile.unknown.empty() ? 0 : of.tile.unknown.back(); };
  const Tiling::OfTile& one = *std::max_element(tiling.tiles.begin(), tiling.tiles.end(),
                                                [&](const auto& l, const auto& r) { return unknown(l) < unknown(r); });
  std::vector<Place> owned, ghosts, settled, unsettled, left;
  for (std::size_t i = 0; i < one.tile.points.size(); ++i) {
    const Place p = place_of(one.tile.points[i]);
    (one.tile.owned[i] != 0 ? owned : ghosts).push_back(p);
    if (one.tile.owned[i] != 0) (one.settled.contains(one.tile.site[i]) ? settled : unsettled).push_back(p);
  }
  for (const std::uint32_t site : tiling.not_done) left.push_back(tiling.places[site]);
  std::size_t found = 0;
  for (const auto& of : tiling.tiles) found += of.triangles.size();

  std::vector<Panel> panels(3);
  panels[0].heading = "(a) one tile";
  panels[0].caption = {number("owned ", owned.size()) + number(" · ghosts ", ghosts.size()),
                       number("of ", points.size()) + number(" points, ", tiling.tiles.size()) + " tiles"};
  panels[0].more = [&](Canvas& canvas, const Frame& frame) {
    const Drawing drawing{canvas, frame};
    drawing.cells(one.tile);
    drawing.dots(tiling.places, 1.4, color::pale);
    drawing.dots(ghosts, 1.8, color::inner);
    drawing.dots(owned, 2.2, color::text);
  };
  panels[1].heading = "(b) its patch";
  panels[1].caption = {number("triangles ", one.triangles.size()),
                       number("settled stars ", settled.size()) + number(" · others ", unsettled.size())};
  panels[1].more = [&](Canvas& canvas, const Frame& frame) {
    const Drawing drawing{canvas, frame};
    drawing.cells(one.tile);
    drawing.dots(tiling.places, 1.4, color::pale);
    drawing.triangles(tiling, one.triangles, color::face);
    drawing.dots(settled, 2.2, color::text);
    drawing.dots(unsettled, 2.6, color::touched);
  };
  panels[2].heading = "(c) what is left over";
  panels[2].caption = {number("triangles of all patches ", found) + number(" · left ", tiling.missing.size()),
                       number("points for these ", tiling.not_done.size())};
  panels[2].more = [&](Canvas& canvas, const Frame& frame) {
    const Drawing drawing{canvas, frame};
    for (const auto& of : tiling.tiles) drawing.triangles(tiling, of.triangles, color::face);
    drawing.triangles(tiling, tiling.missing, color::touched_face);
    drawing.dots(left, 1.8, color::touched);
  };
  for (Panel& panel : panels) {
    panel.extent = {{one.tile.x0, one.tile.y0}, {one.tile.x1(), one.tile.y1()}};
    for (const rbpa::Point& p : points) panel.extent.push_back(place_of(p));
  }
  return Sheet("A tile: its points and ghosts, the patch found on it, and what all tiles leave over", 26, 310)
      .row(panels)
      .svg();
}

}  // namespace figures
