// What: the topology of soups as CGAL's Polygon Mesh Processing sees it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/topology/polygon_soup.h"

namespace rbpa_test {

/// A component of a surface mesh, in numbers.
struct CgalPiece {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t border_cycles = 0;
  long genus = 0;
  friend auto operator<=>(const CgalPiece&, const CgalPiece&) = default;
};

/// Whether the faces are those of an oriented manifold without pinches.
bool cgal_takes(const meshops::PolygonSoup& soup);

/// The faces with directions that agree, copies of points appended where faces come apart.
/// Requires: no corner is out of range, no face degenerate or repeated.
meshops::PolygonSoup cgal_oriented(const meshops::PolygonSoup& soup);

/// The faces that are worth keeping, as lists of the same points: repeated neighbors are named once, then what is no
/// polygon or repeats another goes. Requires: no corner is out of range.
std::vector<std::vector<std::uint32_t>> cgal_kept_faces(const meshops::PolygonSoup& soup);

/// The connected components, sorted. Requires: cgal_takes(soup).
std::vector<CgalPiece> cgal_pieces(const meshops::PolygonSoup& soup);

struct CgalPinches {
  std::size_t points = 0;  ///< with several umbrellas
  std::size_t copies = 0;  ///< that part them
  friend bool operator==(const CgalPinches&, const CgalPinches&) = default;
};

/// Of the surface mesh in which the points of `soup` that stand on one point are made one vertex.
/// Requires: cgal_takes(soup); stands_on[p] <= p is its own.
CgalPinches cgal_pinches(const meshops::PolygonSoup& soup, const std::vector<std::uint32_t>& stands_on);

}  // namespace rbpa_test
