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

/// Computes smallest_covering() from the radii.
std::optional<double> smallest_covering(const Delaunay& delaunay, std::span<const double> radii,
                                        const Covering& covering, Steps& step);

/// Computes complex_at() from the radii.
AlphaComplex complex_at(const Delaunay& delaunay, std::span<const double> radii, double alpha);

}  // namespace rbpa
