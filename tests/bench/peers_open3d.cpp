#include "bench/peers.h"

#ifdef RBPA_BENCH_OPEN3D
#include <open3d/geometry/PointCloud.h>
#include <open3d/geometry/TriangleMesh.h>
#endif

namespace rbpa_bench {

std::optional<Contestant> open3d([[maybe_unused]] const SurfacePoints& samples, [[maybe_unused]] double radius) {
#ifdef RBPA_BENCH_OPEN3D
  const auto run = [&samples, radius] {
    open3d::geometry::PointCloud cloud;
    for (const rbpa::Point3& p : samples.points) cloud.points_.emplace_back(p.x, p.y, p.z);
    for (const rbpa::Point3& n : samples.normals) cloud.normals_.emplace_back(n.x, n.y, n.z);
    const Stopwatch watch;
    const auto mesh = open3d::geometry::TriangleMesh::CreateFromPointCloudBallPivoting(cloud, {radius});
    return watch.run(mesh->triangles_.size());
  };
  return Contestant{"Open3D", run, /*is_exact=*/false};
#else
  return std::nullopt;
#endif
}

}  // namespace rbpa_bench
