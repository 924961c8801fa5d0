#include <cstddef>
#include <span>

#include "meshops/core/contract.h"
#include "rbpa/base/run/input.h"
#include "rbpa/plane/arrays/keep_triangles.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/radii.h"

namespace rbpa {

AlphaComplex complex_at(const Delaunay& of, const Filtration& filtration, double alpha) {
  if (!(alpha > 0))
    throw meshops::ContractViolation("complex_at: found alpha " + text(alpha) +
                                     ", expected a number above 0, or infinity");
  require_same(filtration, of.triangulation(), "complex_at");
  return complex_at(of, std::span<const double>(filtration.triangle_alpha), alpha);
}

AlphaComplex complex_at(const Delaunay& of, std::span<const double> radii, double alpha) {
  AlphaComplex complex = of.triangulation();
  keep_triangles(complex, [&](std::size_t t) { return radii[t] <= alpha; });
  complex.isolated = isolated_in(complex, of.points().size());
  complex.boundary.clear();
  return complex;
}

}  // namespace rbpa
