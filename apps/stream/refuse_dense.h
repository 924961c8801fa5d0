// What: why there are no tiles small enough, and what to do.
#pragma once

#include "stream/budget.h"
#include "stream/plan_tiles.h"
#include "stream/request.h"

namespace rbpa::app {

/// Throws Failure: where, how many points, how many fit, and how much memory would do.
[[noreturn]] void refuse_dense(const TooDense& dense, const StreamRequest& request, const Budget& budget);

}  // namespace rbpa::app
