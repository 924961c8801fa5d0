// What: the contestants of the contest of ball pivoting, in space.
// Law:  on the same points and radius those that are exact find the same triangles; others have definitions of their own.
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
  std::function<Run(const SurfacePoints& samples, double radius)> run;  ///< throws where there is no result
  bool is_exact = true;
  bool is_program = false;  ///< another program, whose memory is measured from outside
};

/// rbpa::surface(): arrays; and with surface_mesh() after it, the mesh.
SurfaceContestant surface_with(unsigned threads);
SurfaceContestant surface_mesh_with(unsigned threads);
/// The policy of apps/examples/ball_pivoting.h on the advancing front: a mesh.
SurfaceContestant ball_pivoting_on_engine();
/// Open3D's TriangleMesh::CreateFromPointCloudBallPivoting with one radius: its mesh. Making its points of ours is not timed.
/// Empty where Open3D was not there when this was compiled.
std::vector<SurfaceContestant> open3d();

/// Any program: a command for the shell in which {in} stands for the name of a PLY file to read, binary little-endian with
/// double x y z nx ny nz, {out} for that of a PLY file to write, of which the number of faces is read, and {radius} for the
/// radius.
/// Time: as shell_run.h has it. Throws std::invalid_argument when {in} or {out} is not in the command.
SurfaceContestant surface_program(const std::string& name, const std::string& command);

/// All in turn, as measure() does it. The radius is in spacings.
Contest measure_surface(const SurfacePoints& samples, double radius, const std::vector<SurfaceContestant>& contestants,
                        const Settings& settings);

}  // namespace rbpa_bench
