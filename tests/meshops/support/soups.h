// Small soups with names, soups at random, and what is true of them by brute force.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "meshops/topology/polygon_soup.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"

namespace meshops::test {

PolygonSoup soup(std::size_t points, std::initializer_list<std::initializer_list<std::uint32_t>> faces);

/// A rectangle of squares cut in two. Its left and right sides are one when `wrap_x`, its lower and upper ones when
/// `wrap_y`, upside down when `flip`: a disc, an annulus, a torus, a Möbius band, a Klein bottle.
PolygonSoup grid_soup(std::uint32_t columns, std::uint32_t rows, bool wrap_x, bool wrap_y, bool flip = false);

/// Five triangles on five points.
PolygonSoup moebius_band();
/// Ten triangles on six points.
PolygonSoup projective_plane();
PolygonSoup klein_bottle();

/// Both, side by side; the points and faces of `b` get the numbers after those of `a`.
PolygonSoup beside(const PolygonSoup& a, const PolygonSoup& b);

/// Up to a dozen triangles, polygons and lists that are no faces, on few points; some repeat others.
PolygonSoup random_soup(std::mt19937& random);

/// A surface of some dozen triangles in which points have been merged, faces reversed and left out at random.
PolygonSoup broken_surface(std::mt19937& random);

/// Point p is point point_to[p], face f is face face_to[f] (f when not `faces_too`), and begins at another corner.
struct Shuffled {
  PolygonSoup soup;
  std::vector<std::uint32_t> point_to;
  std::vector<std::size_t> face_to;
};
Shuffled shuffled(const PolygonSoup& soup, std::mt19937& random, bool faces_too);

/// All corners, for messages: "0 1 2 | 2 1 3".
std::string text(const PolygonSoup& soup);

/// What find_defects() must return, from the definitions alone. Of a component that is not orientable the points are left
/// out. Cost: quadratic and worse.
std::vector<SoupDefect> defects_by_brute_force(const PolygonSoup& soup);

/// What report() must return: ranks of boundary matrices, pieces by search. Cost: cubic.
TopologyReport report_by_brute_force(const PolygonSoup& soup);

/// The ranks of both boundary matrices over Z/2 give the Betti numbers of cells that are glued along their boundaries.
struct Cells {
  std::size_t vertices = 0;
  std::vector<std::vector<std::size_t>> edges;  ///< two vertices each
  std::vector<std::vector<std::size_t>> faces;  ///< edges
};
BettiNumbers betti_by_brute_force(const Cells& cells);

}  // namespace meshops::test
