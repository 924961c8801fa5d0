// What: the exceptions with which a computation of librbpa ends without a result.
#pragma once

#include <stdexcept>

#include "meshops/core/progress.h"
#include "rbpa/base/api.h"

namespace rbpa {

/// Exception for data or parameters that violate the requirements of a function.
class RBPA_API InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Exception that ends a run after its progress callback returned false.
using meshops::Cancelled;

}  // namespace rbpa
