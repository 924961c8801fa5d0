// What: measures each ball's part of a union, and the contacts of balls, on the dual complex of the balls.
// How:  docs/explanation/space.md, section 24. The tetrahedra at each ball are visited twice: first to find which edges
//       at the ball are in the complex, which of them reach the surface, and what is beside triangles; then to add
//       what is in tetrahedra. The end of lower index measures an edge.
// Law:  threads do not change a bit; neither does the choice of contacts and gradients.
// Cost: linear in the tetrahedra.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/triangulated.h"
#include "rbpa/space/balls/measure_balls.h"

namespace rbpa::space {

/// Measures the balls around the points of `cells`. Balls from number `own` on are auxiliary: they meet no other.
/// Requires: a radius for each point; `faces` is the dual complex of these balls; `cells` has tetrahedra and neighbors,
///           and is no periodic box.
/// Throws: Cancelled.
BallMeasures ball_parts(const Triangulated& cells, std::span<const double> radii, std::size_t own,
                        const FacesWithin& faces, const MeasureBallsOptions& options, Threads& threads,
                        const GoOn& go_on);

}  // namespace rbpa::space
