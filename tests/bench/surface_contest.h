// What: the contestants of the contest of ball pivoting in space.
// Law:  on the same points and radius, all exact contestants find the same triangles; the others have definitions of
//       their own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/contest.h"
#include "bench/measure.h"
#include "bench/surface_points.h"

namespace rbpa_bench {

struct SurfaceContestant {
  std::string name;
  std::function<Run(const SurfacePoints& samples, double radius)> run;  ///< throws when there is no result
  bool is_exact = true;
  bool is_program = false;  ///< another program, whose memory is measured from outside
};

/// Runs rbpa::surface(), with arrays as result; or surface_mesh() after it, with a mesh.
SurfaceContestant surface_with(unsigned threads);
SurfaceContestant surface_mesh_with(unsigned threads);
/// Runs the policy of apps/examples/ball_pivoting.h on the advancing front: a mesh.
SurfaceContestant ball_pivoting_on_engine();
/// Returns Open3D's TriangleMesh::CreateFromPointCloudBallPivoting with one radius, whose result is a mesh. Converting
/// our points is not timed. Empty if Open3D was not available at compile time.
std::vector<SurfaceContestant> open3d();

/// Returns any program as a contestant: a command for the shell in which {in} stands for the name of a PLY file to
/// read, binary little-endian with double x y z nx ny nz, {out} for the name of a PLY file to write, whose number of
/// faces is read, and {radius} for the radius.
/// Time: as in shell_run.h. Throws std::invalid_argument when the command lacks {in} or {out}.
SurfaceContestant surface_program(const std::string& name, const std::string& command);

/// Runs all contestants in turn, as measure() does. The radius is in spacings.
Contest measure_surface(const SurfacePoints& samples, double radius, const std::vector<SurfaceContestant>& contestants,
                        const Settings& settings);

}  // namespace rbpa_bench
