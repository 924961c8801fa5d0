// Replaces surface_open3d.cpp in builds without Open3D.
#include "bench/surface_contest.h"

namespace rbpa_bench {

std::vector<SurfaceContestant> open3d() { return {}; }

}  // namespace rbpa_bench
