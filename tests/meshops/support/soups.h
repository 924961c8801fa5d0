// Small soups with names, random soups, and their properties by brute force.
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

/// Returns a rectangle of squares cut in two. Its left and right sides are one if `wrap_x`, its lower and upper ones if
/// `wrap_y`, reversed if `flip`: a disc, an annulus, a torus, a Möbius band, a Klein bottle.
PolygonSoup grid_soup(std::uint32_t columns, std::uint32_t rows, bool wrap_x, bool wrap_y, bool flip = false);

/// Returns five triangles on five points.
PolygonSoup moebius_band();
/// Returns ten triangles on six points.
PolygonSoup projective_plane();
PolygonSoup klein_bottle();

/// Returns both soups, side by side; the points and faces of `b` get the numbers after those of `a`.
PolygonSoup beside(const PolygonSoup& a, const PolygonSoup& b);

/// Returns up to a dozen triangles, polygons and lists that are not faces, on few points; some repeat others.
PolygonSoup random_soup(std::mt19937& random);

/// Returns a surface of some dozen triangles in which points have been merged, and faces reversed and left out, at
/// random.
PolygonSoup broken_surface(std::mt19937& random);

/// Shuffled soup: point p becomes point_to[p], face f becomes face_to[f] (f unless `faces_too`) and begins at another
/// corner.
struct Shuffled {
  PolygonSoup soup;
  std::vector<std::uint32_t> point_to;
  std::vector<std::size_t> face_to;
};
Shuffled shuffled(const PolygonSoup& soup, std::mt19937& random, bool faces_too);

/// Returns all corners as a text for messages: "0 1 2 | 2 1 3".
std::string text(const PolygonSoup& soup);

/// Returns the correct result of find_defects(), from the definitions alone, without the points of components that are
/// not orientable. Cost: quadratic and worse.
std::vector<SoupDefect> defects_by_brute_force(const PolygonSoup& soup);

/// Returns the correct result of report(): by ranks of boundary matrices, and pieces by search. Cost: cubic.
TopologyReport report_by_brute_force(const PolygonSoup& soup);

/// Cells that are glued along their boundaries. The ranks of both boundary matrices over Z/2 give their Betti numbers.
struct Cells {
  std::size_t vertices = 0;
  std::vector<std::vector<std::size_t>> edges;  ///< two vertices each
  std::vector<std::vector<std::size_t>> faces;  ///< edges
};
BettiNumbers betti_by_brute_force(const Cells& cells);

}  // namespace meshops::test
