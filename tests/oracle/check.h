// What: checks every law of a solid alpha complex, given the triangles that an oracle expects.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rbpa/rbpa.h"
#include "support/triangle.h"

namespace rbpa_test {

/// Returns the first broken law, "" when there is none. A law is broken when
///   the mesh has defects, is not the expected triangles, leaves edges of theirs unglued, glues fans that only touch;
///   an input index, an isolated point or a duplicate does not agree with the points.
std::string wrong_with(const rbpa::SolidAlphaComplex& complex, std::span<const rbpa::Point> points,
                       const std::vector<Triangle>& expected);

/// Type of rbpa() and paper::rbpa().
using Rbpa = rbpa::SolidAlphaComplex (*)(std::span<const rbpa::Point>, double, const rbpa::Options&);

/// Returns the first fault of compute(points, alpha) according to CGAL; an exception counts.
std::string wrong_with_rbpa(std::span<const rbpa::Point> points, double alpha, Rbpa compute = rbpa::rbpa);

/// Returns the text to print for a failure: the complaint, and the smallest set of points found in a minute that still
/// fails.
std::string report(const std::string& complaint, const Points& points, double alpha, Rbpa compute = rbpa::rbpa);

}  // namespace rbpa_test
