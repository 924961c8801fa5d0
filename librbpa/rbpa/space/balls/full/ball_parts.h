// What: measures the part of each ball in a union of balls, and the contacts of balls, on the dual complex of the
//       balls.
// How:  docs/explanation/space.md, section 24. The tetrahedra at each ball are visited twice. The first visit finds the
//       edges at the ball that are in the complex, those that reach the surface, and the parts beside triangles; the
//       second one adds the parts in tetrahedra. Each edge is measured at its end of lower index.
// Law:  the number of threads, and the choice of contacts and gradients, do not change a bit of the other results.
// Cost: linear in the tetrahedra.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/triangulated.h"
#include "rbpa/space/balls/measure_balls.h"

namespace rbpa::space {

/// Returns the exponent of a power of two that scales the balls so that products of lengths are within the range of
/// double. Returns 0 if the sizes need no scaling.
int scale_exponent(std::span<const Point3> centers, std::span<const double> radii);

/// Measures the balls around the points of `cells`. Balls from number `own` on are auxiliary: they meet no other ball.
/// Requires: a radius for each point; `faces` is the dual complex of these balls; `cells` has tetrahedra and neighbors,
///           and is no periodic box.
/// Throws: Cancelled.
BallMeasures ball_parts(const Triangulated& cells, std::span<const double> radii, std::size_t own,
                        const FacesWithin& faces, const MeasureBallsOptions& options, Threads& threads,
                        const GoOn& go_on);

}  // namespace rbpa::space
