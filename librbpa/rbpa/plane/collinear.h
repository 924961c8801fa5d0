// What: tests whether all points lie on one line, and explains in words why a complex has no triangle.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"

namespace rbpa {

/// Returns whether all points lie on one line, exactly; true for fewer than three distinct points.
/// Requires: finite points; not checked.
/// Throws:   Cancelled.
/// Cost:     linear; stops at the first point off the line.
RBPA_API bool are_collinear(std::span<const Point> points, const GoOn& go_on = {});

/// Returns why the complex of radius `alpha` has no triangle: "fewer than three distinct points (2)", "all points are
/// collinear" or "no triangle has circumradius <= 0.5". `distinct` is the number of distinct points, `collinear` the
/// result of are_collinear(). Requires: the complex has no triangle; not checked.
RBPA_API std::string why_no_triangle(std::size_t distinct, bool collinear, double alpha);

}  // namespace rbpa
