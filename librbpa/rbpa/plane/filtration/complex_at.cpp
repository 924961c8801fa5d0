#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/filtration.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/radii.h"

namespace rbpa {
namespace {

/// Distinct points in no triangle, ascending.
std::vector<std::uint32_t> isolated_in(const Triangulation& complex, std::size_t points) {
  std::vector<std::uint8_t> is_covered(points, 0);
  for (const Triangle& triangle : complex.triangles)
    for (const std::uint32_t corner : triangle) is_covered[corner] = 1;
  for (const Duplicate& duplicate : complex.duplicates) is_covered[duplicate.index] = 1;
  std::vector<std::uint32_t> isolated;
  for (std::uint32_t i = 0; i < points; ++i)
    if (is_covered[i] == 0) isolated.push_back(i);
  return isolated;
}

}  // namespace

Triangulation complex_at(const Delaunay& of, const Filtration& filtration, double alpha) {
  meshops::require(alpha > 0, "complex_at: alpha is a radius above 0, or infinity");
  require_same(filtration, of.triangulation(), "complex_at");
  return complex_at(of, std::span<const double>(filtration.triangle_alpha), alpha);
}

Triangulation complex_at(const Delaunay& of, std::span<const double> radii, double alpha) {
  const Triangulation& delaunay = of.triangulation();
  Triangulation complex;
  complex.duplicates = delaunay.duplicates;
  complex.distinct = delaunay.distinct;
  std::vector<std::uint32_t> number(delaunay.triangles.size());  // in the complex
  std::uint32_t kept = 0;
  for (std::size_t t = 0; t < number.size(); ++t) {
    const bool is_in = radii[t] <= alpha;
    number[t] = is_in ? kept : Triangulation::none;
    kept += is_in;
  }
  complex.triangles.reserve(kept);
  complex.neighbors.reserve(kept);
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (number[t] == Triangulation::none) continue;
    complex.triangles.push_back(delaunay.triangles[t]);
    Triangle& across = complex.neighbors.emplace_back(delaunay.neighbors[t]);
    for (std::uint32_t& neighbor : across)
      if (neighbor != Triangulation::none) neighbor = number[neighbor];
  }
  complex.isolated = isolated_in(complex, of.points().size());
  return complex;
}

}  // namespace rbpa
