// What: the exceptions with which a computation of librbpa ends without a result.
#pragma once

#include <stdexcept>

#include "meshops/core/progress.h"
#include "rbpa/base/api.h"

namespace rbpa {

/// Thrown when the caller's data or parameters violate the function's requirements; nothing was computed.
class RBPA_API InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Thrown when the progress callback returned false.
using meshops::Cancelled;

}  // namespace rbpa
