// What: rebuilds a solid from arrays of Python.
#pragma once

#include <span>
#include <vector>

#include "python/arrays.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::python {

/// Returns a solid with copies of `simplices` and `neighbors`; its other members are left at their defaults.
inline Solid solid_again(const Indices& simplices, const Indices& neighbors) {
  Solid again;
  const auto rows_of = [](std::span<const Quadruple> rows) { return std::vector(rows.begin(), rows.end()); };
  again.simplices = rows_of(quadruples_of(simplices, "simplices"));
  again.neighbors = rows_of(quadruples_of(neighbors, "neighbors"));
  return again;
}

}  // namespace rbpa::python
