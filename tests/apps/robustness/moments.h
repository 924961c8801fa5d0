// What: --moments=N of the test programs: how often each hazard happens to each verb.
#pragma once

#include "support/arguments.h"

namespace robustness {

inline int moments() { return static_cast<int>(rbpa_test::argument("moments", 1)); }

}  // namespace robustness
