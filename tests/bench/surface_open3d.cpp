// Open3D as a contestant, in a library of its own, so that nothing else is compiled with its headers.
#include <open3d/geometry/PointCloud.h>
#include <open3d/geometry/TriangleMesh.h>

#include "bench/stopwatch.h"
#include "bench/surface_contest.h"

namespace rbpa_bench {

std::vector<SurfaceContestant> open3d() {
  const auto run = [](const SurfacePoints& samples, double radius) {
    open3d::geometry::PointCloud cloud;
    for (const rbpa::Point3& p : samples.points) cloud.points_.emplace_back(p.x, p.y, p.z);
    for (const rbpa::Point3& n : samples.normals) cloud.normals_.emplace_back(n.x, n.y, n.z);
    const Stopwatch watch;
    const auto mesh = open3d::geometry::TriangleMesh::CreateFromPointCloudBallPivoting(cloud, {radius});
    Run result{watch.seconds(), mesh->triangles_.size()};
    result.processor_seconds = watch.processor_seconds();
    return result;
  };
  return {{"Open3D", run, /*is_exact=*/false}};
}

}  // namespace rbpa_bench
