// What: how often each thing happens to each verb: --moments=N of the test programs.
#pragma once

#include "support/arguments.h"

namespace robustness {

inline int moments() { return static_cast<int>(rbpa_test::argument("moments", 1)); }

}  // namespace robustness
