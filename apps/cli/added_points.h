// What: points that are added to a cloud, with all that its points have: means of that of the points between which they are.
#pragma once

#include "cli/left_out_points.h"
#include "io/cloud/read_space_points.h"
#include "rbpa/estimate_normals.h"
#include "triangulation/close_surface.h"

namespace rbpa::app {

/// Behind the others: to the cloud, the normals that are estimated, if there are any, and what is left out. Normals are unit
/// vectors.
void add_points(const AddedPoints& added, SpacePoints& cloud, EstimatedNormals& estimated, LeftOutPoints& left_out);

}  // namespace rbpa::app
