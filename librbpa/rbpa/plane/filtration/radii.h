// What: the radii of a filtration by themselves, for what needs no counts of its steps.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/covering.h"
#include "rbpa/delaunay.h"

namespace rbpa {

/// Filtration::triangle_alpha.
std::vector<double> radii_of(const Delaunay& delaunay, Steps& step);

/// smallest_covering() by the radii.
std::optional<double> smallest_covering(const Delaunay& delaunay, std::span<const double> radii,
                                        const Covering& covering, Steps& step);

/// complex_at() by the radii.
Triangulation complex_at(const Delaunay& delaunay, std::span<const double> radii, double alpha);

}  // namespace rbpa
