// What: checks alpha and a region for the functions of this folder.
#pragma once

#include <string>

#include "rbpa/plane/region.h"

namespace rbpa {

/// Checks that 0 < alpha < ∞. Throws: InvalidInput, with the reason why infinity is not allowed.
void check_finite(double alpha);

/// Checks that bounds are numbers in ascending order. Throws: InvalidInput.
void check(const Region& region);

std::string text(const Region& region);

}  // namespace rbpa
