// What: computes the radii of a filtration alone, for functions that need no counts.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/smallest_covering_alpha.h"

namespace rbpa {

/// Returns for each triangle the least double alpha that admits it, as Filtration::triangle_alpha has it.
std::vector<double> radii_of(const Delaunay& delaunay, Steps& step);

/// Returns smallest_covering() for `radii` = radii_of(delaunay).
/// Throws: ContractViolation when the share is out of its bounds; Cancelled.
std::optional<double> smallest_covering(const Delaunay& delaunay, std::span<const double> radii,
                                        const Covering& covering, Steps& step);

/// Returns complex_at() for `radii` = radii_of(delaunay). Requires: 0 < alpha ≤ infinity.
AlphaComplex complex_at(const Delaunay& delaunay, std::span<const double> radii, double alpha);

}  // namespace rbpa
