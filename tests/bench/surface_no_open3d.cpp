// Where Open3D is not there.
#include "bench/surface_contest.h"

namespace rbpa_bench {

std::vector<SurfaceContestant> open3d() { return {}; }

}  // namespace rbpa_bench
