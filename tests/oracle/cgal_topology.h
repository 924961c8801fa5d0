// What: the topology of soups according to CGAL's Polygon Mesh Processing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/topology/polygon_soup.h"

namespace rbpa_test {

/// Component of a surface mesh, in numbers.
struct CgalPiece {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t border_cycles = 0;
  long genus = 0;
  friend auto operator<=>(const CgalPiece&, const CgalPiece&) = default;
};

/// Returns whether the faces form an oriented manifold without pinches.
bool cgal_takes(const meshops::PolygonSoup& soup);

/// Returns the faces with directions that agree; copies of points are appended where faces are separated.
/// Requires: no corner is out of range, no face degenerate or repeated.
meshops::PolygonSoup cgal_oriented(const meshops::PolygonSoup& soup);

/// Returns the faces worth keeping, as lists of the same points: repeated neighbors are named once, then faces that are
/// no polygon or repeat another one are removed. Requires: no corner is out of range.
std::vector<std::vector<std::uint32_t>> cgal_kept_faces(const meshops::PolygonSoup& soup);

/// Returns the connected components, sorted. Requires: cgal_takes(soup).
std::vector<CgalPiece> cgal_pieces(const meshops::PolygonSoup& soup);

struct CgalPinches {
  std::size_t points = 0;  ///< number of points with several umbrellas
  std::size_t copies = 0;  ///< number of copies that separate the umbrellas
  friend bool operator==(const CgalPinches&, const CgalPinches&) = default;
};

/// Returns the pinches of the surface mesh in which the points of `soup` that stand on one point are made one vertex.
/// Requires: cgal_takes(soup); stands_on[p] <= p, and stands_on[stands_on[p]] is stands_on[p].
CgalPinches cgal_pinches(const meshops::PolygonSoup& soup, const std::vector<std::uint32_t>& stands_on);

}  // namespace rbpa_test
