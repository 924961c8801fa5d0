// What: asserts that a mesh has no defect.
#pragma once

#include <doctest/doctest.h>

#include "meshops/core/validate.h"

namespace meshops::test {

inline void check_sound(const Connectivity& mesh) {
  for (const Defect& defect : validate(mesh)) FAIL_CHECK(describe(defect));
}

}  // namespace meshops::test
