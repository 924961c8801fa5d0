#include "rbpa/plane/filtration/growth.h"
#include "rbpa/base/triangle.h"

#include <algorithm>
#include <array>

#include "rbpa/plane/filtration/ordered_triangles.h"

namespace rbpa {
namespace {

std::vector<std::uint32_t> first_vertices(const std::vector<std::uint32_t>& input_index) {
  const auto last = std::max_element(input_index.begin(), input_index.end());
  std::vector<std::uint32_t> on_point(last == input_index.end() ? 0 : *last + 1u, no_index);
  std::vector<std::uint32_t> first(input_index.size());
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    std::uint32_t& found = on_point[input_index[v]];
    if (found == no_index) found = v;
    first[v] = found;
  }
  return first;
}

}  // namespace

Growth::Growth(const TriangleArrays& arrays, std::size_t vertices, const std::vector<std::uint32_t>& point_of_vertex)
    : arrays_(arrays),
      first_on_point_(first_vertices(point_of_vertex)),
      gaps_(gaps_of(arrays, vertices)),
      solids_(arrays.triangles.size()),
      pieces_(vertices),
      in_(arrays.triangles.size()),
      on_(vertices),
      point_on_(vertices) {}

void Growth::add(std::uint32_t triangle) {
  const Triangle& corners = arrays_.triangles[triangle];
  in_[triangle] = true;
  ++now_.triangles;
  ++now_.solid_components;
  std::array<bool, 3> glued;  // whether the side across from the corner is glued
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t neighbor = arrays_.neighbors[triangle][k];
    glued[k] = neighbor != TriangleArrays::none && in_[neighbor];
    if (glued[k])
      now_.solid_components -= solids_.join(triangle, neighbor);
    else
      ++now_.edges;
  }
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t corner = corners[k];
    const bool before = glued[(k + 1) % 3], behind = glued[(k + 2) % 3];
    --gaps_[corner];
    if (!before && !behind) ++fans_;
    // A triangle between two others at a point joins their fans, unless it fills the last gap of a single fan.
    if (before && behind && gaps_[corner] > 0) --fans_;
    if (!on_[corner]) cover(corner);
    now_.components -= pieces_.join(corners[0], corner);
  }
}

void Growth::cover(std::uint32_t vertex) {
  on_[vertex] = true;
  const std::uint32_t first = first_on_point_.empty() ? vertex : first_on_point_[vertex];
  pieces_.join(first, vertex);
  if (point_on_[first]) return;
  point_on_[first] = true;
  ++now_.points_covered;
  ++now_.components;
}

ComplexCounts Growth::counts() const {
  ComplexCounts counts = now_;
  counts.holes = counts.components + counts.edges - counts.points_covered - counts.triangles;  // components − χ
  // A surface that lies in the plane has no handles: χ = 2 components − curves, with a vertex for each fan.
  counts.boundary_curves = 2 * counts.solid_components + counts.edges - fans_ - counts.triangles;
  return counts;
}

}  // namespace rbpa
