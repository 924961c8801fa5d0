// What: the requirements of this folder's functions on alpha and on a region.
#pragma once

#include <string>

#include "rbpa/region.h"

namespace rbpa {

/// Throws InvalidInput unless 0 < alpha < ∞, with the reason why not infinity.
void check_finite(double alpha);

/// Throws InvalidInput unless bounds are numbers in ascending order.
void check(const Region& region);

std::string text(const Region& region);

}  // namespace rbpa
