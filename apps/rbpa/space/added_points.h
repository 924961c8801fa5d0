// What: adds points to a cloud; normals, colors and confidences are means over the three points around each.
#pragma once

#include "io/cloud/read_space_points.h"
#include "rbpa/space/repair/refine_filling.h"
#include "rbpa/space/surface/estimate_normals.h"
#include "space/left_out_points.h"

namespace rbpa::app {

/// Appends the points to the cloud, to the estimated normals if there are any, and to `left_out`. Their normals are
/// unit vectors.
void add_points(const AddedPoints& added, SpacePoints& cloud, EstimatedNormals& estimated, LeftOutPoints& left_out);

}  // namespace rbpa::app
